#pragma once

#include <span>
#include <vector>

#include "crowd/ClipTimeline.h"
#include "walkcycle/animation/Animation.h"

namespace walkcycle {

// Lays a clip out as timelines. `slots[joint]` is where that joint's transform is to be written; below 0: nobody asks for
// it. Channels with like key times share a timeline; together they hold at most some four times as many numbers as
// the keys did. Where two channels move one joint, the later one counts, as in sample(Animation).
std::vector<ClipTimeline> makeTimelines(const Animation& animation, std::span<const int> slots);

}  // namespace walkcycle
