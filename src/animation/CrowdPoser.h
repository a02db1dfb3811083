#pragma once

#include <memory>
#include <span>

#include "animation/FastPoser.h"

namespace walkcycle {

// A FastPoser on several processors: the palettes of a crowd, shared out in small portions. Its threads start once and
// sleep between calls.
class CrowdPoser {
public:
    // `threads` work, the calling one included; 0: as many as the machine has processors.
    explicit CrowdPoser(const FastPoser& poser, unsigned int threads = 0);
    ~CrowdPoser();
    CrowdPoser(const CrowdPoser&) = delete;
    CrowdPoser& operator=(const CrowdPoser&) = delete;

    std::size_t paletteSize() const;

    // As FastPoser::pose of many; returns when all are done. Not to be called by two threads at once. Allocates nothing.
    void pose(std::span<const double> seconds, std::span<JointRows> palettes);

private:
    class Workers;
    std::unique_ptr<Workers> workers_;
};

}  // namespace walkcycle
