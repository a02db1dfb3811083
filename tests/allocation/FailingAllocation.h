#pragma once

#include <cstdint>

namespace walkcycle {

// While it lives, one request for memory of this thread is refused: the n-th from now on, counted from 1. All
// requests count, those of the C libraries below us as well; with the sanitizers, which have an allocator of their
// own, only those of C++.
class FailingAllocation {
public:
    explicit FailingAllocation(std::uint64_t n);
    ~FailingAllocation();
    FailingAllocation(const FailingAllocation&) = delete;

    bool happened() const;
    static std::uint64_t requests();  // since the last one was made
};

}  // namespace walkcycle
