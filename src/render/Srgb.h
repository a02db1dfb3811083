#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace walkcycle {

// Converts between sRGB (IEC 61966-2-1), the numbers that pictures and screens use, and linear light. Both are from 0
// to 1, or sRGB from 0 to 255 as a byte.
float linearOfSrgb(float encoded);
float linearOfSrgb(std::uint8_t encoded);  // by table
std::uint8_t srgbOfLinear(float light);    // rounded to the nearest byte; by table
glm::vec3 linearOfSrgb(const glm::vec3& encoded);

}  // namespace walkcycle
