#include "io/Jpeg.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <turbojpeg.h>

#include "io/ImageSize.h"

namespace walkcycle {
namespace {

using Decoder = std::unique_ptr<void, int (*)(tjhandle)>;

// CMYK files store inverted values, as the programs of Adobe do: 255 is no ink.
void cmykToRgba(Bytes& pixels) {
    for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c)
            pixels[i + c] = static_cast<std::uint8_t>(pixels[i + c] * pixels[i + 3] / 255);
        pixels[i + 3] = 255;
    }
}

// Whether a fault leaves no picture. Small faults, such as bytes between markers, leave one; a truncated file
// does not.
bool isFatal(const Decoder& decoder) {
    return tjGetErrorCode(decoder.get()) == TJERR_FATAL ||
           std::string_view(tjGetErrorStr2(decoder.get())).find("Premature end") != std::string_view::npos;
}

[[noreturn]] void fail(const Decoder& decoder) {
    throw ImageError(std::string("the JPEG picture is damaged (") + tjGetErrorStr2(decoder.get()) + ")");
}

}  // namespace

bool looksLikeJpeg(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= 3 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
}

Image decodeJpeg(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    const Decoder decoder(tjInitDecompress(), tjDestroy);
    if (!decoder) throw ImageError("no JPEG decoder can be made");
    const auto size = static_cast<unsigned long>(bytes.size());
    int width = 0, height = 0, subsampling = 0, colors = 0;
    if (tjDecompressHeader3(decoder.get(), bytes.data(), size, &width, &height, &subsampling, &colors) != 0 &&
        isFatal(decoder))
        fail(decoder);
    checkSize(width, height, bytes.size(), limits);
    Image image = emptyImage(width, height, false);
    const bool inks = colors == TJCS_CMYK || colors == TJCS_YCCK;
    if (tjDecompress2(decoder.get(), bytes.data(), size, image.rgba.data(), width, 0, height,
                      inks ? TJPF_CMYK : TJPF_RGBA, TJFLAG_LIMITSCANS) != 0 &&
        isFatal(decoder))
        fail(decoder);
    if (inks) cmykToRgba(image.rgba);
    return image;
}

}  // namespace walkcycle
