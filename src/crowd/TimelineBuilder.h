#pragma once

#include <span>
#include <vector>

#include "crowd/ClipTimeline.h"
#include "walkcycle/animation/Animation.h"

namespace walkcycle {

// Makes the timelines of a clip. `slots[joint]` is where that joint's transform will be written; joints with a slot below 0
// are left out. Channels with similar key times share a timeline; a timeline holds at most some four times as many numbers
// as the keys. If two channels move one joint, the later one counts, as in Animator.
std::vector<ClipTimeline> makeTimelines(const Animation& animation, std::span<const int> slots);

}  // namespace walkcycle
