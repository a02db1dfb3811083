#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <walkcycle/Export.h>
#include <walkcycle/animation/Animation.h>
#include <walkcycle/animation/Joint.h>
#include <walkcycle/animation/JointRows.h>
#include <walkcycle/animation/Skin.h>

namespace walkcycle {

// Makes the palettes of one clip for one skin: of any number of characters that differ in nothing but their time, which
// is all there is to keep of each. The palettes are those of Animator and computePalette, to 1e-6 (of the larger of 1 and
// the number); docs/performance.md says how much faster they come. The work is shared out to threads in small
// portions; they start once and sleep between calls.
class WALKCYCLE_API CrowdPoser {
public:
    // Keeps nothing of its arguments but `threads`: how many work, the calling one included (so 1 starts none). 0: as many
    // as the machine has processors.
    CrowdPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin,
               unsigned int threads = 0);
    ~CrowdPoser();
    CrowdPoser(CrowdPoser&&) noexcept;
    CrowdPoser& operator=(CrowdPoser&&) noexcept;

    std::size_t paletteSize() const;  // Skin::joints.size()
    double lengthInSeconds() const;   // of the clip

    // One palette after the other: that of seconds[i] since the clip's start begins at palettes[i * paletteSize()], and
    // there must be room for all. Wraps around the clip's ends, forwards and backwards. Returns when all are done. Not to
    // be called by two threads at once. Allocates nothing.
    void pose(std::span<const double> seconds, std::span<JointRows> palettes);

    // The same for a single character.
    void poseOne(double seconds, std::span<JointRows> palette);

private:
    class Workers;
    std::unique_ptr<Workers> workers_;
};

}  // namespace walkcycle
