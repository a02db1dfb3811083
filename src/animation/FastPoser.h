#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "animation/Animation.h"
#include "animation/Float4.h"
#include "animation/Joint.h"
#include "animation/JointRows.h"
#include "animation/Skin.h"

namespace walkcycle {

// Makes the palettes of one clip for one skin: any number of characters that differ in nothing but their time, which is
// all there is to keep of each. Does what PlainPoser does, with the same results to 1e-6 (of the larger of 1 and the
// number), some ten times as fast: keys lie in tables (ClipTimeline), four joints are blended at once, transforms are
// three rows instead of four columns, and joints that do not reach the skin are left out.
//
// Copies share the tables. One FastPoser must not be used by two threads at once; each takes a copy (see CrowdPoser).
class FastPoser {
public:
    // Keeps nothing of its arguments.
    FastPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin);

    std::size_t paletteSize() const;  // Skin::joints.size()
    double lengthInSeconds() const;

    // The palette (as computePalette makes it) at `seconds` since the clip's start; wraps around the clip's ends, forwards
    // and backwards. `palette` must have paletteSize() entries. Allocates nothing.
    void pose(double seconds, std::span<JointRows> palette);

    // One after the other: the palette of seconds[i] begins at palettes[i * paletteSize()], and there must be room for all.
    void pose(std::span<const double> seconds, std::span<JointRows> palettes);

    std::size_t tableBytes() const;  // what all copies share

private:
    struct Tables;
    void walk();

    std::shared_ptr<const Tables> tables_;
    std::vector<Rows> locals_, models_;  // of the joints that matter, parents first
};

}  // namespace walkcycle
