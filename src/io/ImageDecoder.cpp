#include "io/ImageDecoder.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>

#include <webp/decode.h>

#include "io/ImageSize.h"
#include "io/Jpeg.h"

namespace {

// The largest block that stb_image may allocate at the moment. stb_image trusts the lengths in a file: a PNG
// of 200 bytes can make it ask for two gigabytes.
thread_local std::size_t largestBlock = 0;
// Set if a block within that limit could not be allocated: then memory is exhausted, and the file is not at
// fault.
thread_local bool outOfMemory = false;

void* allocateBlock(std::size_t bytes) {
    void* block = bytes <= largestBlock ? std::malloc(bytes) : nullptr;
    outOfMemory = outOfMemory || (!block && bytes <= largestBlock);
    return block;
}
void* resizeBlock(void* block, std::size_t bytes) {
    void* resized = bytes <= largestBlock ? std::realloc(block, bytes) : nullptr;
    outOfMemory = outOfMemory || (!resized && bytes <= largestBlock);
    return resized;
}

}  // namespace

// The code of stb_image, with only the formats that textures use. Our own limits are checked below.
#define STBI_ONLY_PNG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_ONLY_GIF
#define STBI_ONLY_PSD
#define STBI_NO_STDIO
#define STBI_MALLOC(bytes) allocateBlock(bytes)
#define STBI_REALLOC(block, bytes) resizeBlock(block, bytes)
#define STBI_FREE(block) std::free(block)
#define STBI_MAX_DIMENSIONS 65536
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace walkcycle {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

bool isWebp(ByteSpan bytes) {
    return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
           std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

Image decodeWebp(ByteSpan bytes, const ImageLimits& limits) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK)
        throw ImageError("the WebP header is damaged");
    if (features.has_animation) throw ImageError("animated WebP is not supported");
    checkSize(features.width, features.height, bytes.size(), limits);
    Image image = emptyImage(features.width, features.height, features.has_alpha != 0);
    if (!WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(),
                            image.width * 4))
        throw ImageError("the WebP data are damaged or cut short");
    return image;
}

// Some TGA writers store four bytes per pixel, and 0 as the fourth. The picture is meant to be opaque, not
// invisible.
void dropEmptyAlpha(Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 0) return;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    image.hasAlpha = false;
}

bool isTga(ByteSpan bytes) {  // TGA has no signature; the other formats begin with these bytes
    const std::array<ByteSpan::value_type, 5> firsts = {0x89, 'B', 'G', '8', 'P'};
    for (const std::uint8_t first : firsts)
        if (bytes[0] == first) return false;
    return true;
}

// The blocks of an intact file hold its pixels with 16 bits per channel, or its packed bytes. stb_image may
// double either size once.
constexpr std::size_t kBlockMargin = 1 << 20, kBlockPerByte = 4, kBlockPerPixel = 16;

Image decodeWithStb(ByteSpan bytes, const ImageLimits& limits) {
    const int size = static_cast<int>(bytes.size());
    int width = 0, height = 0, components = 0;
    largestBlock = kBlockMargin;
    outOfMemory = false;
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &components))
        throw ImageError(std::string("not a picture of a known kind (") + stbi_failure_reason() + ")");
    checkSize(width, height, bytes.size(), limits);
    largestBlock = kBlockMargin + kBlockPerByte * bytes.size() +
                   kBlockPerPixel * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &components, 4), stbi_image_free);
    if (!pixels && outOfMemory) throw std::bad_alloc();
    if (!pixels) throw ImageError(std::string("the picture is damaged (") + stbi_failure_reason() + ")");
    checkSize(width, height, bytes.size(), limits);
    Image image = emptyImage(width, height, components == 2 || components == 4);
    std::memcpy(image.rgba.data(), pixels.get(), image.rgba.size());
    if (image.hasAlpha && isTga(bytes)) dropEmptyAlpha(image);
    return image;
}

// Whether the PNG has its first and its last chunk. A truncated file has no last chunk.
bool isWholePng(ByteSpan bytes) {
    constexpr std::array<std::uint8_t, 8> start{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    constexpr std::array<std::uint8_t, 12> end{0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82};
    return bytes.size() > start.size() + end.size() &&
           std::equal(start.begin(), start.end(), bytes.begin()) &&
           std::equal(end.begin(), end.end(), bytes.end() - end.size());
}

}  // namespace

Image decodeImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    if (bytes.empty()) throw ImageError("the picture is empty (0 bytes)");
    if (bytes.size() > INT_MAX) throw ImageError("the picture is over 2 GB");
    if (isWebp(bytes)) return decodeWebp(bytes, limits);
    if (looksLikeJpeg(bytes)) return decodeJpeg(bytes, limits);
    return decodeWithStb(bytes, limits);
}

Image measureImage(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    int width = 0, height = 0, components = 0;
    largestBlock = kBlockMargin;
    if (!isWholePng(bytes) || bytes.size() > INT_MAX ||
        !stbi_info_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height, &components))
        return decodeImage(bytes, limits);
    checkSize(width, height, bytes.size(), limits);
    return Image{.width = width, .height = height, .hasAlpha = components % 2 == 0, .rgba = {}};
}

}  // namespace walkcycle
