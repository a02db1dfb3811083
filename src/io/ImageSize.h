#pragma once

#include <cstddef>
#include <cstdint>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// Checks the size of a picture, in pixels, before it is decoded. `bytes` is the size of its file. Throws
// ImageError if there are no pixels, or more than so many bytes can hold under any compression: then the file
// is truncated, or made to exhaust memory. Throws ImageTooLarge if a limit is exceeded.
void checkSize(std::int64_t width, std::int64_t height, std::size_t bytes, const ImageLimits& limits);

// A picture filled with transparent black.
Image emptyImage(int width, int height, bool hasAlpha);

}  // namespace walkcycle
