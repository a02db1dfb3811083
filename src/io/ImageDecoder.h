#pragma once

#include <cstdint>
#include <span>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// Decodes PNG, JPEG, TGA, BMP, GIF (the first frame), PSD and WebP. Throws ImageError with the reason, or
// ImageTooLarge.
Image decodeImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits = {});

// The same for callers that need only the size. If the file is an intact PNG, its pixels are not decoded, and
// `rgba` is empty.
Image measureImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits = {});

}  // namespace walkcycle
