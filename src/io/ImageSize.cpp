#include "io/ImageSize.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace walkcycle {
namespace {

// The most pixels that one byte can hold: the deflate of PNG compresses at most 1032 to 1, that is some 8,000
// pixels of one bit.
constexpr std::int64_t kMostPixelsPerByte = 16384;

}  // namespace

void checkSize(std::int64_t width, std::int64_t height, std::size_t bytes, const ImageLimits& limits) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width <= 0 || height <= 0) throw ImageError("the picture has no pixels (" + size + ")");
    const auto side = static_cast<std::uint64_t>(std::max(width, height));
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (side > limits.maxDimension)
        throw ImageTooLarge("the picture is " + size + " pixels; the limit is " +
                                std::to_string(limits.maxDimension) + " a side",
                            side, &ImageLimits::maxDimension);
    if (pixels > limits.maxPixels)
        throw ImageTooLarge("the picture is " + size + " pixels; the limit is " +
                                std::to_string(limits.maxPixels) + " in all",
                            pixels, &ImageLimits::maxPixels);
    if (width * height > kMostPixelsPerByte * static_cast<std::int64_t>(bytes))
        throw ImageError("the picture is cut short: " + std::to_string(bytes) + " bytes for " + size +
                         " pixels");
}

Image emptyImage(int width, int height, bool hasAlpha) {
    Image image{.width = width, .height = height, .hasAlpha = hasAlpha, .rgba = {}};
    image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0);
    return image;
}

}  // namespace walkcycle
