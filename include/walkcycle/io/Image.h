#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <walkcycle/Export.h>
#include <walkcycle/io/Bytes.h>

namespace walkcycle {

// A picture in memory.
struct Image {
    int width = 0, height = 0;  // in pixels
    bool hasAlpha = false;      // the file had an alpha channel
    // Rows from the top, four bytes per pixel: red, green, blue, alpha; sRGB, straight alpha. Empty where only the size was
    // asked for.
    Bytes rgba;
};

// The largest picture that decodeImage (ImageDecoder.h) accepts, so that a file of a few bytes cannot cost gigabytes.
struct ImageLimits {
    std::uint64_t maxDimension = 16384;          // pixels on a side
    std::uint64_t maxPixels = 64 * 1024 * 1024;  // width * height
};

// Bytes that are no picture that can be used: what() says why, in one line.
struct WALKCYCLE_API ImageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The picture exceeds one of ImageLimits.
struct WALKCYCLE_API ImageTooLarge : ImageError {
    ImageTooLarge(const std::string& what, std::uint64_t found, std::uint64_t ImageLimits::*passed)
        : ImageError(what), amount(found), limit(passed) {}
    std::uint64_t amount;               // what the file claims
    std::uint64_t ImageLimits::*limit;  // which of the limits
};

// The bytes of a picture file. Throw ImageError where the picture has no pixels.
WALKCYCLE_API Bytes encodePng(const Image& image);
WALKCYCLE_API Bytes encodeWebp(const Image& image);  // lossless

}  // namespace walkcycle
