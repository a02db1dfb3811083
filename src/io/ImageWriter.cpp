#include <array>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include <libdeflate.h>
#include <webp/encode.h>

#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

// Level 1 writes 640 x 480 pixels in 3 ms. The bytes depend on the version of libdeflate, not on the machine.
constexpr int kDeflateLevel = 1;
constexpr std::uint8_t kFilterUp =
    2;  // stores each byte minus the one above it: areas of one colour become zeros

void checkImage(const Image& image) {
    const std::size_t bytes =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    if (image.width <= 0 || image.height <= 0 || image.rgba.size() != bytes)
        throw ImageError("the picture has no pixels to write");
}

void putBigEndian(Bytes& out, std::uint32_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(number >> shift));
}

void putChunk(Bytes& out, const char* type, std::span<const std::uint8_t> data) {
    putBigEndian(out, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = out.size();
    out.insert(out.end(), type, type + 4);
    out.insert(out.end(), data.begin(), data.end());
    putBigEndian(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

Bytes header(const Image& image, bool alpha) {
    Bytes data;
    putBigEndian(data, static_cast<std::uint32_t>(image.width));
    putBigEndian(data, static_cast<std::uint32_t>(image.height));
    const std::array<std::uint8_t, 5> kind = {8, static_cast<std::uint8_t>(alpha ? 6 : 2), 0, 0, 0};
    data.insert(data.end(), kind.begin(), kind.end());
    return data;
}

// A row of a PNG before compression: a filter byte, then RGB or RGBA.
template <std::size_t channels>
void filterRow(const std::uint8_t* row, const std::uint8_t* above, std::size_t width, std::uint8_t* to) {
    *to++ = kFilterUp;
    for (std::size_t x = 0; x < width; ++x, row += 4, above += 4, to += channels)
        for (std::size_t c = 0; c < channels; ++c) to[c] = static_cast<std::uint8_t>(row[c] - above[c]);
}

Bytes filteredRows(const Image& image, bool alpha) {
    const std::size_t width = static_cast<std::size_t>(image.width),
                      height = static_cast<std::size_t>(image.height);
    const std::size_t rowBytes = 1 + width * (alpha ? 4 : 3);
    const auto filter = alpha ? filterRow<4> : filterRow<3>;
    Bytes rows(height * rowBytes);
    const std::vector<std::uint8_t> black(width * 4);
    const std::uint8_t* above = black.data();
    for (std::size_t y = 0; y < height; ++y) {
        const std::uint8_t* row = image.rgba.data() + y * width * 4;
        filter(row, above, width, rows.data() + y * rowBytes);
        above = row;
    }
    return rows;
}

Bytes deflated(const Bytes& data) {
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(kDeflateLevel), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), data.size());
    Bytes packed(most);
    packed.resize(
        libdeflate_zlib_compress(compressor.get(), data.data(), data.size(), packed.data(), packed.size()));
    return packed;
}

}  // namespace

Bytes encodePng(const Image& image) {
    checkImage(image);
    const Bytes data = deflated(filteredRows(image, image.hasAlpha));
    if (data.size() > INT_MAX) throw ImageError("the picture is too large for a PNG");
    Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    putChunk(png, "IHDR", header(image, image.hasAlpha));
    const std::array<std::uint8_t, 1> perceptual = {0};
    putChunk(png, "sRGB", perceptual);
    putChunk(png, "IDAT", data);
    putChunk(png, "IEND", {});
    return png;
}

Bytes encodeWebp(const Image& image) {
    checkImage(image);
    if (image.width > WEBP_MAX_DIMENSION || image.height > WEBP_MAX_DIMENSION)
        throw ImageError("WebP holds at most " + std::to_string(WEBP_MAX_DIMENSION) +
                         " pixels a side; write PNG instead");
    WebPConfig config;
    WebPPicture picture;
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, 1) || !WebPPictureInit(&picture))
        throw ImageError("this libwebp is of another version than the one Walkcycle was built with");
    config.exact = 1;  // keep the colours of transparent pixels
    picture.use_argb = 1;
    picture.width = image.width;
    picture.height = image.height;
    WebPMemoryWriter memory;
    WebPMemoryWriterInit(&memory);
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &memory;
    const int stride = image.width * 4;
    const bool imported = image.hasAlpha ? WebPPictureImportRGBA(&picture, image.rgba.data(), stride)
                                         : WebPPictureImportRGBX(&picture, image.rgba.data(), stride);
    const bool encoded = imported && WebPEncode(&config, &picture);
    WebPPictureFree(&picture);
    const std::unique_ptr<std::uint8_t, void (*)(void*)> owner(memory.mem, WebPFree);
    if (!encoded)
        throw ImageError("the picture cannot be written as WebP (error " +
                         std::to_string(picture.error_code) + ")");
    return {memory.mem, memory.mem + memory.size};
}

}  // namespace walkcycle
