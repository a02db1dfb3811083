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

// Computes the palettes of one clip for one skin, for any number of characters that differ only in their time: the
// caller keeps nothing else of a character. The palettes differ from those of Animator and computePalette by at most 1e-6,
// times the largest number of Skin::bindMatrices if that is larger than 1; docs/performance.md says how much faster they
// are computed. Several threads share the work in small portions; they start once and sleep between calls.
class WALKCYCLE_API CrowdPoser {
public:
    // Copies what it needs: skeleton, animation and skin need not outlive it. `threads` is how many threads work,
    // including the caller's (so 1 starts none), at most 256; 0 means one per processor.
    CrowdPoser(const Skeleton& skeleton, const Animation& animation, const Skin& skin,
               unsigned int threads = 0);
    ~CrowdPoser();
    CrowdPoser(CrowdPoser&&) noexcept;
    CrowdPoser& operator=(CrowdPoser&&) noexcept;

    std::size_t paletteSize() const;  // matrices per palette: Skin::joints.size()
    double lengthInSeconds() const;   // of the clip

    // Writes one palette per character: that of seconds[i], counted from the clip's start, begins at
    // palettes[i * paletteSize()]. `palettes` must have room for all of them. Times before the clip's start and after its
    // end wrap around. Returns when all palettes are written. Allocates nothing. Two threads must not call it at once.
    void pose(std::span<const double> seconds, std::span<JointRows> palettes);

    // The same for a single character.
    void poseOne(double seconds, std::span<JointRows> palette);

private:
    class Workers;
    std::unique_ptr<Workers> workers_;
};

}  // namespace walkcycle
