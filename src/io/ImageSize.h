#pragma once

#include <cstddef>
#include <cstdint>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// Throws ImageError if the size is zero or over a limit, or if `bytes`, the size of the file, cannot hold so
// many pixels under any compression: such a file is cut short, or a decompression bomb.
void checkSize(std::int64_t width, std::int64_t height, std::size_t bytes, const ImageLimits& limits);

// A picture of transparent black.
Image emptyImage(int width, int height, bool hasAlpha);

}  // namespace walkcycle
