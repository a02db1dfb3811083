#pragma once

#include "io/Bytes.h"
#include "io/Image.h"

namespace walkcycle {

// The bytes of a picture file. Throw ImageError where the picture has no pixels.
Bytes encodePng(const Image& image);
Bytes encodeWebp(const Image& image);  // lossless

}  // namespace walkcycle
