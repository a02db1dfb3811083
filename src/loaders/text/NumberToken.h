#pragma once

#include <cstdint>

namespace walkcycle {

// Parses the word [first, last), which is not empty. Returns false unless the whole word is a number in the type's range;
// a double must also be in the range of a float, since the model is made of floats.
bool parseToken(const char* first, const char* last, float& value);
bool parseToken(const char* first, const char* last, double& value);
bool parseToken(const char* first, const char* last, std::int32_t& value);
bool parseToken(const char* first, const char* last, std::uint64_t& value);

}  // namespace walkcycle
