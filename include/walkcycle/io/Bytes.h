#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <walkcycle/Export.h>

namespace walkcycle {

// What Bytes is allocated with: bytes that resize() adds stay uninitialised unless a value is given.
struct WALKCYCLE_API BytesAllocator {
    using value_type = std::uint8_t;
    template <typename Other>
    struct rebind {
        using other = BytesAllocator;  // there are no other elements
    };

    std::uint8_t* allocate(std::size_t count);  // throws std::bad_alloc
    void deallocate(std::uint8_t* memory, std::size_t count) noexcept;
    void construct(std::uint8_t*) {}
    template <typename Value>
    void construct(std::uint8_t* at, Value&& value) {
        std::construct_at(at, static_cast<std::uint8_t>(std::forward<Value>(value)));
    }
    friend bool operator==(const BytesAllocator&, const BytesAllocator&) { return true; }
};

// The bytes of a file or a picture. resize(n) leaves the bytes that it adds uninitialised; resize(n, 0)
// zeroes them.
using Bytes = std::vector<std::uint8_t, BytesAllocator>;

}  // namespace walkcycle
