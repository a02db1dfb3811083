#pragma once

#include <cstdint>
#include <span>

#include "walkcycle/io/Image.h"

namespace walkcycle {

bool looksLikeJpeg(std::span<const std::uint8_t> bytes);

// JPEG of every kind: baseline and progressive, grey, YCbCr and CMYK. Throws ImageError.
// Uses libjpeg-turbo, because Debian's stb_image writes past a table when a file's Huffman codes are damaged.
Image decodeJpeg(std::span<const std::uint8_t> bytes, const ImageLimits& limits);

}  // namespace walkcycle
