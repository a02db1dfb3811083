#include "walkcycle/io/Bytes.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace walkcycle {
namespace {

constexpr std::align_val_t kLargePage{std::size_t{2} << 20};

}  // namespace

void* allocateLarge(std::size_t bytes) {
    void* const memory = ::operator new(bytes, kLargePage);
#ifdef MADV_HUGEPAGE
    ::madvise(memory, bytes, MADV_HUGEPAGE);  // a hint: where it has no effect, pages stay small
#endif
    return memory;
}

void freeLarge(void* memory) noexcept {
    ::operator delete(memory, kLargePage);
}

}  // namespace walkcycle
