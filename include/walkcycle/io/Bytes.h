#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <walkcycle/Export.h>

namespace walkcycle {

// The allocator of Bytes: bytes that resize() adds stay uninitialised unless a value is given, which saves a
// pass over the memory of each file and picture.
struct WALKCYCLE_API BytesAllocator {
    using value_type = std::uint8_t;
    template <typename Other>
    struct rebind {
        using other = BytesAllocator;  // its only element type is a byte
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

// The bytes of a file or a picture. resize(n) leaves the bytes that it adds uninitialised; resize(n, 0) sets
// them to zero.
using Bytes = std::vector<std::uint8_t, BytesAllocator>;

}  // namespace walkcycle
