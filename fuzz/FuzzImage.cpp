// Any bytes as a picture.

#include "Require.h"
#include "io/Image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr walkcycle::ImageLimits kLimits{.maxDimension = 1024, .maxPixels = 1 << 16};
    try {
        const walkcycle::Image image = walkcycle::decodeImage({data, size}, kLimits);
        REQUIRE(image.width > 0 && image.width <= kLimits.maxDimension);
        REQUIRE(image.height > 0 && image.height <= kLimits.maxDimension);
        const std::int64_t pixels = std::int64_t{image.width} * image.height;
        REQUIRE(pixels <= kLimits.maxPixels);
        REQUIRE(image.rgba.size() == static_cast<std::size_t>(pixels) * 4);
    } catch (const walkcycle::ImageError&) {
    }
    return 0;
}
