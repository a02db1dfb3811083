#pragma once

#include <optional>

#include "io/Image.h"

namespace walkcycle {

// Reads the PNG files of every day, which are RGB or RGBA with 8 bits a channel, whole and without interlacing, five
// times as fast as stb_image. Nothing where it is any other: stb_image reads that, or says what is wrong.
std::optional<Image> decodePlainPng(std::span<const std::uint8_t> bytes, const ImageLimits& limits);

// The same without pixels. Nothing also where a part of the file is missing.
std::optional<Image> measurePlainPng(std::span<const std::uint8_t> bytes, const ImageLimits& limits);

}  // namespace walkcycle
