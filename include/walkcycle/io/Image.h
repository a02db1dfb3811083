#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <walkcycle/Export.h>
#include <walkcycle/io/Bytes.h>

namespace walkcycle {

// A picture: 8 bits per channel, sRGB.
struct Image {
    int width = 0, height = 0;  // in pixels
    bool hasAlpha = false;      // whether the file has an alpha channel
    // Rows from top to bottom, four bytes per pixel: red, green, blue, and alpha, which is not premultiplied.
    // Empty if only the size was asked for.
    Bytes rgba;
};

// The largest picture that is decoded, because a file of a few bytes may claim gigabytes.
struct ImageLimits {
    std::uint64_t maxDimension = 16384;          // pixels on a side
    std::uint64_t maxPixels = 64 * 1024 * 1024;  // width * height
};

// A picture that cannot be decoded or encoded. what() gives the reason in one line.
struct WALKCYCLE_API ImageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The picture exceeds one of ImageLimits.
struct WALKCYCLE_API ImageTooLarge : ImageError {
    ImageTooLarge(const std::string& what, std::uint64_t found, std::uint64_t ImageLimits::*passed)
        : ImageError(what), amount(found), limit(passed) {}
    std::uint64_t amount;               // the number that the file claims
    std::uint64_t ImageLimits::*limit;  // the exceeded limit
};

// Encode a picture as a file, without loss. Throw ImageError if the picture has no pixels or is too large for
// the format (WebP: 16383 pixels per side).
WALKCYCLE_API Bytes encodePng(const Image& image);
WALKCYCLE_API Bytes encodeWebp(const Image& image);

}  // namespace walkcycle
