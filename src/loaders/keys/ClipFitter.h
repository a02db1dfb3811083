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

// The work of fitting a whole motion, for LoadProgress.
double workOf(const Motion& motion);

// Fits the key frames of clips to the exact motion, within LoadOptions::tolerance. If keys cannot do that,
// the clips come as near as they can, and WC0513 is reported.
//
// A smaller tolerance never gives a larger Animation::achievedError. For that, tolerances are rounded to
// levels, two per decade, and the levels are always fitted in the same order: from level 0, the default
// tolerance, to the finer or to the coarser ones, as far as the requested tolerance needs.
class ClipFitter {
public:
    ClipFitter(const Model& model, const Motion& motion, const LoadContext& context, XmlNode collada);

    // Returns the whole timeline, called `name`, then the clips. A clip in which nothing moves is left out.
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
    std::uint64_t keys_ = 0;         // of the current level
    std::size_t spareKeys_ = 0;      // left for the motions of the clip, beyond the keys of the file
    std::size_t spareKeysEach_ = 0;  // the most that one motion may take
    bool ranOut_ = false;            // no spare keys left: a smaller tolerance gives no better clips
};

}  // namespace walkcycle
