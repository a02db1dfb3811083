#include "allocation/FailingAllocation.h"

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

thread_local std::uint64_t asked = 0, refusedAt = 0;

bool isRefused() {
    return ++asked == refusedAt;
}

}  // namespace

namespace walkcycle {

FailingAllocation::FailingAllocation(std::uint64_t n) {
    asked = 0;
    refusedAt = n;
}
FailingAllocation::~FailingAllocation() {
    refusedAt = 0;
}
bool FailingAllocation::happened() const {
    return asked >= refusedAt;
}
std::uint64_t FailingAllocation::requests() {
    return asked;
}

}  // namespace walkcycle

#ifndef WALKCYCLE_ADDRESS_SANITIZER

// Hidden, as this build compiles everything, they would serve this program alone and not the libraries that it loads.
#define FOR_ALL_LIBRARIES __attribute__((visibility("default")))

// glibc's own, under the names that it keeps for this purpose; operator new asks them as well.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);

FOR_ALL_LIBRARIES void* malloc(std::size_t size) {
    if (!isRefused()) return __libc_malloc(size);
    errno = ENOMEM;
    return nullptr;
}
FOR_ALL_LIBRARIES void* calloc(std::size_t count, std::size_t size) {
    if (!isRefused()) return __libc_calloc(count, size);
    errno = ENOMEM;
    return nullptr;
}
FOR_ALL_LIBRARIES void* realloc(void* memory, std::size_t size) {
    if (!isRefused()) return __libc_realloc(memory, size);
    errno = ENOMEM;
    return nullptr;
}
}

#else

// The array forms end up here too.
void* operator new(std::size_t size) {
    void* memory = isRefused() ? nullptr : std::malloc(size ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {  // std::stable_sort's
    return isRefused() ? nullptr : std::malloc(size ? size : 1);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

#endif
