#pragma once

#include <cstddef>

namespace walkcycle {

// How often this test program has asked for memory so far: a frame must not.
std::size_t allocationCount();

}  // namespace walkcycle
