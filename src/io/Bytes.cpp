#include "walkcycle/io/Bytes.h"

#include <cstddef>
#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace walkcycle {
namespace {

// Memory for a large file uses huge pages if the system has them. With pages of 4 KB, the page faults take as
// long as reading the file.
constexpr std::size_t kLarge = std::size_t{8} << 20;
constexpr std::align_val_t kLargePage{std::size_t{2} << 20};

void* allocateLarge(std::size_t bytes) {
    void* const memory = ::operator new(bytes, kLargePage);
#ifdef MADV_HUGEPAGE
    ::madvise(memory, bytes, MADV_HUGEPAGE);  // only a hint: if the system ignores it, pages stay small
#endif
    return memory;
}

}  // namespace

std::uint8_t* BytesAllocator::allocate(std::size_t count) {
    return static_cast<std::uint8_t*>(count < kLarge ? ::operator new(count) : allocateLarge(count));
}

void BytesAllocator::deallocate(std::uint8_t* memory, std::size_t count) noexcept {
    if (count < kLarge)
        ::operator delete(memory);
    else
        ::operator delete(memory, kLargePage);
}

}  // namespace walkcycle
