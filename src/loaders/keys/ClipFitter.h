#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/curves/ClipLoader.h"
#include "loaders/curves/Motion.h"
#include "loaders/keys/KeyFrameFitter.h"
#include "loaders/keys/MotionReach.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// What all that moves, or one of it, counts as work of fitting (see LoadProgress): by the keys of its curves.
double workOf(const Motion& motion);

// Makes clips of key frames from the exact motion, within LoadOptions::tolerance. Where keys cannot do that, the clips
// come as near as they can, and WC0513 is reported.
//
// A smaller tolerance never gives a larger Animation::achievedError. For that, the fitter knows two tolerances per
// decade, its levels, and fits them in one order for all: the default tolerance is level 0, and from there it goes to
// the finer or to the coarser ones, as far as the tolerance asks for.
class ClipFitter {
public:
    ClipFitter(const Model& model, const Motion& motion, const LoadContext& context, XmlNode collada);

    // The whole timeline first, which is called `name`, then the clips. A clip in which nothing moves is left out.
    std::vector<Animation> fit(const std::string& name, const std::vector<ClipRange>& clips);

private:
    struct Source {
        const std::string& name;
        const std::vector<ClipRange>& clips;
    };
    std::vector<Animation> refine(const Source& source, int level, double tolerance);
    void coarsen(const Source& source, int level, std::vector<Animation>& animations);

    std::vector<Animation> fitLevel(const Source& source, int level);
    void fitClip(const Motion& motion, const Animation* whole, int level, Animation& animation);
    void fitMotions(const Motion& motion, const Animation* whole, int level, Animation& animation);
    KeyLimits keyLimits() const;
    void count(std::size_t keys, std::size_t knots);

    const Model& model_;
    const Motion& motion_;
    const LoadContext& context_;
    XmlNode collada_;
    MotionReach reach_;
    std::uint64_t keys_ = 0;         // of this level
    std::size_t spareKeys_ = 0;      // that the motions of a clip may still take beyond those of the file
    std::size_t spareKeysEach_ = 0;  // what one of them may take
    bool ranOut_ = false;            // of spare keys: a smaller tolerance gives no better clips
};

}  // namespace walkcycle
