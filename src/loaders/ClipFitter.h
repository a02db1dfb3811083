#pragma once

#include <string>

#include "loaders/LoadContext.h"
#include "loaders/Motion.h"
#include "loaders/MotionReach.h"
#include "model/Model.h"

namespace walkcycle {

// What all that moves, or one of it, counts as work of fitting (see LoadProgress): by the keys of its curves.
double workOf(const Motion& motion);

// Makes clips of keyframes from the exact motion, within LoadOptions::tolerance.
class ClipFitter {
public:
    ClipFitter(const Model& model, const Motion& motion, const LoadContext& context, XmlNode collada);

    // Everything that moves, over the whole timeline.
    Animation whole(std::string name);
    // A part of it. `motion` holds the channels that play. What moves as in `whole` is cut out of it.
    Animation clip(std::string name, double start, double end, const Motion& motion, const Animation& whole);

private:
    void fit(const Motion& motion, const Animation* whole, Animation& animation);
    void count(std::size_t keys);

    const Model& model_;
    const Motion& motion_;
    const LoadContext& context_;
    XmlNode collada_;
    MotionReach reach_;
    double share_;  // of the model's size: what each joint's budget is made from
    std::uint64_t keys_ = 0;
    std::size_t spare_ = 0;  // keys that motions may still take beyond those of the file
};

}  // namespace walkcycle
