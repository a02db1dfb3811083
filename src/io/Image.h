#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "io/Bytes.h"

namespace walkcycle {

// A picture in memory: rows from the top, four bytes (red, green, blue, alpha; straight alpha, sRGB) per
// pixel.
struct Image {
    int width = 0;
    int height = 0;
    bool hasAlpha = false;  // the file had an alpha channel
    Bytes rgba;
};

// How large a picture may be before decodeImage (ImageDecoder.h) refuses it, so that a few bytes cannot cost gigabytes.
struct ImageLimits {
    std::uint64_t maxDimension = 16384;
    std::uint64_t maxPixels = 64 * 1024 * 1024;
};

struct ImageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// One of ImageLimits is passed.
struct ImageTooLarge : ImageError {
    ImageTooLarge(const std::string& what, std::uint64_t found, std::uint64_t ImageLimits::*passed)
        : ImageError(what), amount(found), limit(passed) {}
    std::uint64_t amount;
    std::uint64_t ImageLimits::*limit;
};

}  // namespace walkcycle
