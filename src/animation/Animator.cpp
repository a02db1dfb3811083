#include "animation/Animator.h"

#include <algorithm>
#include <cmath>

namespace walkcycle {

Animator::Animator(const Skeleton& skeleton, std::span<const float> restParameters)
    : skeleton_(&skeleton),
      restPose_(skeleton),
      pose_(restPose_),
      restParameters_(restParameters.begin(), restParameters.end()),
      parameters_(restParameters_) {
    walkcycle::modelTransforms(*skeleton_, pose_, modelTransforms_);
}

// What the last clip moved and the next one does not goes back to where the file has it. Copies into the same
// memory, so it allocates nothing.
void Animator::rest() {
    pose_ = restPose_;
    std::copy(restParameters_.begin(), restParameters_.end(), parameters_.begin());
}

void Animator::doAnimation(const Animation& animation) {
    animation_ = &animation;
    rest();
    setTime(0.0);
}

void Animator::update(double seconds) {
    setTime(time_ + seconds);
}

void Animator::setTime(double seconds) {
    if (!animation_) return;
    time_ = loop(seconds, animation_->lengthInSeconds());
    sampleAt(animation_->startSeconds + time_);
}

void Animator::sampleAt(double documentSeconds) {
    if (!animation_) return;
    const double time = std::clamp(documentSeconds, animation_->startSeconds,
                                   std::max(animation_->startSeconds, animation_->endSeconds));
    time_ = time - animation_->startSeconds;
    sample(*animation_, time, pose_, parameters_);
    walkcycle::modelTransforms(*skeleton_, pose_, modelTransforms_);
}

double loop(double seconds, double length) {
    if (!(length > 0.0) || !std::isfinite(seconds)) return 0.0;
    const double wrapped = seconds - length * std::floor(seconds / length);
    // A hair before the start rounds to the length itself, which is the start again.
    return wrapped >= 0.0 && wrapped < length ? wrapped : 0.0;
}

}  // namespace walkcycle
