#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace walkcycle {

// Memory for as much as a large file holds, in large pages where the system has them: to get it in small ones takes as
// long as to read it. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory) noexcept;

// Leaves new elements as they are: what is read into at once need not be zeroed before.
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

// What a file or a picture holds. (resize(n) does not fill what it adds; resize(n, 0) does.)
using Bytes = std::vector<std::uint8_t, UnfilledAllocator<std::uint8_t>>;

}  // namespace walkcycle
