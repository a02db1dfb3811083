#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace walkcycle {

// Conversions between the numbers in files and screens (sRGB, IEC 61966-2-1) and linear amounts of light.
float linearOfSrgb(float encoded);
float linearOfSrgb(std::uint8_t encoded);  // by table
std::uint8_t srgbOfLinear(float light);    // rounded to the nearest byte; by table
glm::vec3 linearOfSrgb(const glm::vec3& encoded);

}  // namespace walkcycle
