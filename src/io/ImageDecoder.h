#pragma once

#include <cstdint>
#include <span>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// Decodes PNG, JPEG, TGA, BMP, GIF (first frame), PSD and WebP. Throws ImageError saying what is wrong.
Image decodeImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits = {});

// The same for callers that need the size alone: where the file's header says it, the pixels are not decoded.
Image measureImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits = {});

}  // namespace walkcycle
