#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "walkcycle/animation/Animator.h"
#include "walkcycle/animation/JointRows.h"
#include "walkcycle/animation/Skin.h"

namespace walkcycle {

// The palettes of one clip for one skin, by way of the Animator: what CrowdPoser must agree with. What it is given must
// outlive it.
class PlainPoser {
public:
    PlainPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin)
        : animator_(skeleton), animation_(&animation), skin_(&skin) {
        animator_.doAnimation(animation);
    }

    std::size_t paletteSize() const { return skin_->joints.size(); }
    double lengthInSeconds() const { return animation_->lengthInSeconds(); }

    void pose(double seconds, std::span<JointRows> palette) {
        animator_.setTime(seconds);
        computePalette(*skin_, animator_.modelTransforms(), matrices_);
        for (std::size_t i = 0; i < palette.size(); ++i) palette[i] = JointRows(matrices_[i]);
    }

private:
    Animator animator_;
    const Animation* animation_;
    const Skin* skin_;
    std::vector<glm::mat4> matrices_;
};

}  // namespace walkcycle
