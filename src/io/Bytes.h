#pragma once

#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace walkcycle {

// Leaves new elements as they are: what is read into at once need not be zeroed before.
template <typename T>
struct UnfilledAllocator : std::allocator<T> {
    template <typename U>
    struct rebind {
        using other = UnfilledAllocator<U>;
    };
    template <typename U>
    void construct(U* at) {
        ::new (static_cast<void*>(at)) U;
    }
    template <typename U, typename... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
};

// What a file or a picture holds. (resize(n) does not fill what it adds; resize(n, 0) does.)
using Bytes = std::vector<std::uint8_t, UnfilledAllocator<std::uint8_t>>;

}  // namespace walkcycle
