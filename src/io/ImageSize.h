#pragma once

#include "io/Image.h"

namespace walkcycle {

// Throws ImageError unless a picture of this size may be made. `bytes` is the size of the file: one that claims more
// pixels than any packing gives is cut short, or a bomb.
void checkSize(std::int64_t width, std::int64_t height, std::size_t bytes, const ImageLimits& limits);

// All of it transparent black.
Image emptyImage(int width, int height, bool hasAlpha);

}  // namespace walkcycle
