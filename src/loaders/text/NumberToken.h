#pragma once

#include <cstdint>

namespace walkcycle {

// One word as a number, in full rigour: nothing left over, within the type's range, and for floating-point numbers within
// that of a float as well, since the model is made of those. `first` and `last` enclose it; it is not empty.
bool parseToken(const char* first, const char* last, float& value);
bool parseToken(const char* first, const char* last, double& value);
bool parseToken(const char* first, const char* last, std::int32_t& value);
bool parseToken(const char* first, const char* last, std::uint64_t& value);

}  // namespace walkcycle
