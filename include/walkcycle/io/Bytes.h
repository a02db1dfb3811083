#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace walkcycle {

// Memory for a large file, in huge pages if the system has them: with pages of 4 KB, the page faults take as
// long as reading the file. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory) noexcept;

// An allocator that leaves new elements uninitialised: a buffer that is filled by a read need not be zeroed
// before.
template <typename T>
struct UnfilledAllocator {
    using value_type = T;
    static constexpr std::size_t kLarge = (std::size_t{8} << 20) / sizeof(T);

    UnfilledAllocator() = default;
    template <typename U>
    UnfilledAllocator(const UnfilledAllocator<U>&) {}

    T* allocate(std::size_t count) {
        if (count < kLarge) return std::allocator<T>().allocate(count);
        return static_cast<T*>(allocateLarge(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (count < kLarge)
            std::allocator<T>().deallocate(memory, count);
        else
            freeLarge(memory);
    }
    template <typename U>
    void construct(U* at) {
        ::new (static_cast<void*>(at)) U;
    }
    template <typename U, typename... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
    friend bool operator==(const UnfilledAllocator&, const UnfilledAllocator&) { return true; }
};

// The bytes of a file or a picture. resize(n) leaves the bytes that it adds uninitialised; resize(n, 0)
// zeroes them.
using Bytes = std::vector<std::uint8_t, UnfilledAllocator<std::uint8_t>>;

}  // namespace walkcycle
