#pragma once

#include <cstdint>
#include <span>

#include "walkcycle/io/Image.h"

namespace walkcycle {

bool looksLikeJpeg(std::span<const std::uint8_t> bytes);

// Decodes JPEG of every kind: baseline and progressive, grey, YCbCr and CMYK. Throws ImageError. Uses
// libjpeg-turbo, because the stb_image of Debian writes beyond a table if the Huffman codes of a file are
// damaged.
Image decodeJpeg(std::span<const std::uint8_t> bytes, const ImageLimits& limits);

}  // namespace walkcycle
