#pragma once

#include <vector>

#include "walkcycle/animation/KeyFrame.h"

namespace walkcycle {

// The two key frames around a time; the same one twice if it holds at that time. `Key` is KeyFrame, MatrixKeyFrame or
// ParameterKeyFrame.
template <class Key>
struct PreviousAndNext {
    const Key& previous;
    const Key& next;
};

// The steps of Animator::calculateCurrentAnimationPose, defined in Animator.cpp.

// `keyFrames` are sorted by time and not empty. The first key frame holds before its time, the last after its time. Of
// two at the same time (a jump), the second counts from that time on.
template <class Key>
PreviousAndNext<Key> getPreviousAndNextFrames(const std::vector<Key>& keyFrames, double seconds);

// The share of the way from one time to another, 0 to 1; 0 if both are the same.
float calculateProgression(double previousSeconds, double nextSeconds, double seconds);

JointTransform interpolatePoses(const KeyFrame& previous, const KeyFrame& next, float progression);

}  // namespace walkcycle
