#pragma once

#include <vector>

#include "walkcycle/animation/KeyFrame.h"

namespace walkcycle {

// The two key frames around a time; the same one twice while it holds. `Key` is a KeyFrame or another kind of key
// frame: all share the search.
template <class Key>
struct PreviousAndNext {
    const Key& previous;
    const Key& next;
};

// The steps of Animator::calculateCurrentAnimationPose, in Animator.cpp.

// `keyFrames` are in rising time and not empty. Before the first key frame the first holds, after the last the last.
// Of two at one time (a jump), the second counts from that time on.
template <class Key>
PreviousAndNext<Key> getPreviousAndNextFrames(const std::vector<Key>& keyFrames, double seconds);

// How far a time is on the way from one time to another, 0 to 1; 0 if both are the same.
float calculateProgression(double previousSeconds, double nextSeconds, double seconds);

JointTransform interpolatePoses(const KeyFrame& previous, const KeyFrame& next, float progression);

}  // namespace walkcycle
