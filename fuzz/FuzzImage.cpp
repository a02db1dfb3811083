// Any bytes as a picture.

#include <cstddef>
#include <cstdint>

#include "Require.h"
#include "io/ImageDecoder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr walkcycle::ImageLimits kLimits{.maxDimension = 1024, .maxPixels = 1 << 16};
    try {
        const walkcycle::Image image = walkcycle::decodeImage({data, size}, kLimits);
        const int most = static_cast<int>(kLimits.maxDimension);
        REQUIRE(image.width > 0 && image.width <= most);
        REQUIRE(image.height > 0 && image.height <= most);
        const auto pixels = static_cast<std::uint64_t>(std::int64_t{image.width} * image.height);
        REQUIRE(pixels <= kLimits.maxPixels);
        REQUIRE(image.rgba.size() == static_cast<std::size_t>(pixels) * 4);
    } catch (const walkcycle::ImageError&) {
    }
    return 0;
}
