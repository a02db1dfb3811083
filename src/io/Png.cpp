#include "io/Png.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#ifdef __SSE2__
#include <emmintrin.h>
#endif
#include <libdeflate.h>

#include "io/ImageSize.h"

namespace walkcycle {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

constexpr std::size_t kSignature = 8, kChunkFrame = 12;  // a chunk's length, name and check sum

std::uint32_t bigEndian(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
           bytes[3];
}

struct Chunk {
    std::string_view name;
    ByteSpan data;
};

// The chunk at `at`, which moves behind it; nothing where it is cut short.
std::optional<Chunk> nextChunk(ByteSpan bytes, std::size_t& at) {
    if (bytes.size() < at + kChunkFrame) return {};
    const std::uint8_t* start = bytes.data() + at;
    const std::size_t length = bigEndian(start);
    if (length > bytes.size() - at - kChunkFrame) return {};
    at += kChunkFrame + length;
    return Chunk{{reinterpret_cast<const char*>(start + 4), 4}, {start + 8, length}};
}

struct Plain {
    std::uint32_t width = 0, height = 0;
    std::size_t channels = 0;
    ByteSpan packed;                   // the picture's zlib stream
    std::vector<std::uint8_t> joined;  // where it stood in several chunks

    std::size_t rowBytes() const { return width * channels; }
};

// 8 bits a channel, RGB or RGBA, not interlaced.
bool readHeader(const Chunk& chunk, Plain& png) {
    if (chunk.name != "IHDR" || chunk.data.size() != 13) return false;
    const std::uint8_t* data = chunk.data.data();
    png.width = bigEndian(data);
    png.height = bigEndian(data + 4);
    png.channels = data[9] == 2 ? 3 : data[9] == 6 ? 4 : 0;
    return data[8] == 8 && png.channels != 0 && data[10] == 0 && data[11] == 0 && data[12] == 0;
}

// What changes the picture's meaning: a transparent colour, a palette, and what a reader must know or give up.
bool isUnusual(std::string_view name) {
    return name == "tRNS" || (name[0] & 0x20) == 0;
}

bool readChunks(ByteSpan bytes, Plain& png) {
    constexpr std::uint8_t signature[kSignature] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    if (bytes.size() < kSignature || std::memcmp(bytes.data(), signature, kSignature) != 0) return false;
    std::size_t at = kSignature, parts = 0;
    std::optional<Chunk> chunk = nextChunk(bytes, at);
    if (!chunk || !readHeader(*chunk, png)) return false;
    while ((chunk = nextChunk(bytes, at)) && chunk->name != "IEND") {
        if (chunk->name != "IDAT") {
            if (isUnusual(chunk->name)) return false;
            continue;
        }
        if (++parts == 2) png.joined.assign(png.packed.begin(), png.packed.end());
        if (parts > 1) png.joined.insert(png.joined.end(), chunk->data.begin(), chunk->data.end());
        png.packed = parts > 1 ? ByteSpan(png.joined) : chunk->data;
    }
    return chunk && parts > 0;
}

// The rows before filtering, a filter byte before each, at the end of memory that has room for four bytes a pixel: the
// pixels made of them never reach those that are still to be read.
class Rows {
public:
    explicit Rows(const Plain& png)
        : size_(png.height * (1 + png.rowBytes())),
          memory_(std::size_t{png.height} * (1 + std::size_t{4} * png.width) + kReadWidth) {}

    bool unpack(ByteSpan packed) {
        const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
            libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
        if (!decompressor) throw std::bad_alloc();
        return libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), first(), size_,
                                          nullptr) == LIBDEFLATE_SUCCESS;
    }
    std::uint8_t* first() { return memory_.data() + (memory_.size() - kReadWidth - size_); }
    std::vector<std::uint8_t>& memory() { return memory_; }

private:
    static constexpr std::size_t kReadWidth = 4;  // the last pixel is read so wide, whatever its channels
    std::size_t size_;
    std::vector<std::uint8_t> memory_;
};

// A pixel's channels in 16 bits each, so that sums and differences fit.
#ifdef __SSE2__
using Pixel = __m128i;

Pixel load(const std::uint8_t* bytes) {
    int pixel;
    std::memcpy(&pixel, bytes, 4);
    return _mm_unpacklo_epi8(_mm_cvtsi32_si128(pixel), _mm_setzero_si128());
}
void store(std::uint8_t* bytes, Pixel pixel) {
    const int narrow = _mm_cvtsi128_si32(_mm_packus_epi16(pixel, pixel));
    std::memcpy(bytes, &narrow, 4);
}
Pixel sum(Pixel a, Pixel b) {
    return _mm_add_epi16(a, b);
}
Pixel lowByte(Pixel a) {
    return _mm_and_si128(a, _mm_set1_epi16(255));
}
Pixel half(Pixel a) {
    return _mm_srli_epi16(a, 1);
}
// Of left, above and above left, the one nearest to left + above - aboveLeft (PNG, "Filter type 4: Paeth").
Pixel paeth(Pixel left, Pixel above, Pixel aboveLeft) {
    const auto size = [](Pixel p) { return _mm_max_epi16(p, _mm_sub_epi16(_mm_setzero_si128(), p)); };
    const auto choose = [](Pixel mask, Pixel a, Pixel b) {
        return _mm_or_si128(_mm_and_si128(mask, a), _mm_andnot_si128(mask, b));
    };
    const Pixel a = _mm_sub_epi16(above, aboveLeft), b = _mm_sub_epi16(left, aboveLeft);
    const Pixel farLeft = size(a), farAbove = size(b), farBoth = size(_mm_add_epi16(a, b));
    const Pixel least = _mm_min_epi16(farBoth, _mm_min_epi16(farLeft, farAbove));
    return choose(_mm_cmpeq_epi16(least, farLeft), left,
                  choose(_mm_cmpeq_epi16(least, farAbove), above, aboveLeft));
}
#else
using Pixel = std::array<int, 4>;

template <typename Make>
Pixel perChannel(Make make) {
    return {make(0), make(1), make(2), make(3)};
}
Pixel load(const std::uint8_t* bytes) {
    return perChannel([=](std::size_t c) { return int{bytes[c]}; });
}
void store(std::uint8_t* bytes, const Pixel& pixel) {
    for (std::size_t c = 0; c < 4; ++c) bytes[c] = static_cast<std::uint8_t>(pixel[c]);
}
Pixel sum(const Pixel& a, const Pixel& b) {
    return perChannel([&](std::size_t c) { return a[c] + b[c]; });
}
Pixel lowByte(const Pixel& a) {
    return perChannel([&](std::size_t c) { return a[c] & 255; });
}
Pixel half(const Pixel& a) {
    return perChannel([&](std::size_t c) { return a[c] / 2; });
}
// Of left, above and above left, the one nearest to left + above - aboveLeft (PNG, "Filter type 4: Paeth").
Pixel paeth(const Pixel& left, const Pixel& above, const Pixel& aboveLeft) {
    return perChannel([&](std::size_t c) {
        const int a = above[c] - aboveLeft[c], b = left[c] - aboveLeft[c];
        const int farLeft = std::abs(a), farAbove = std::abs(b), farBoth = std::abs(a + b);
        if (farLeft <= farAbove && farLeft <= farBoth) return left[c];
        return farAbove <= farBoth ? above[c] : aboveLeft[c];
    });
}
#endif

// Takes a filter back: each byte was stored less what `guess` makes of its neighbours. The row above has four bytes a
// pixel, like the row that is made.
template <std::size_t channels, typename Guess>
void unfilter(const std::uint8_t* in, const std::uint8_t* above, std::size_t width, std::uint8_t* out,
              Guess guess) {
    Pixel left{}, aboveLeft{};
    for (std::size_t x = 0; x < width; ++x, in += channels, above += 4, out += 4) {
        const Pixel up = load(above);
        left = lowByte(sum(load(in), guess(left, up, aboveLeft)));
        aboveLeft = up;
        store(out, left);
    }
}

template <std::size_t channels>
bool unfilterRow(const std::uint8_t* in, const std::uint8_t* above, std::size_t width, std::uint8_t* out) {
    const auto run = [&](auto guess) { unfilter<channels>(in + 1, above, width, out, guess); };
    switch (in[0]) {
        case 0:
            run([](const Pixel&, const Pixel&, const Pixel&) { return Pixel{}; });
            return true;
        case 1:
            run([](const Pixel& left, const Pixel&, const Pixel&) { return left; });
            return true;
        case 2:
            run([](const Pixel&, const Pixel& up, const Pixel&) { return up; });
            return true;
        case 3:
            run([](const Pixel& left, const Pixel& up, const Pixel&) { return half(sum(left, up)); });
            return true;
        case 4:
            run([](const Pixel& left, const Pixel& up, const Pixel& upLeft) {
                return paeth(left, up, upLeft);
            });
            return true;
        default:
            return false;
    }
}

// Pixels of three channels were read with the next one's first byte as their fourth.
void makeOpaque(std::vector<std::uint8_t>& rgba) {
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
}

}  // namespace

std::optional<Image> measurePlainPng(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    Plain png;
    if (!readChunks(bytes, png)) return {};
    checkSize(png.width, png.height, bytes.size(), limits);
    return Image{.width = static_cast<int>(png.width),
                 .height = static_cast<int>(png.height),
                 .hasAlpha = png.channels == 4,
                 .rgba = {}};
}

std::optional<Image> decodePlainPng(std::span<const std::uint8_t> bytes, const ImageLimits& limits) {
    Plain png;
    if (!readChunks(bytes, png)) return {};
    checkSize(png.width, png.height, bytes.size(), limits);
    const auto unfilterAnyRow = png.channels == 3 ? unfilterRow<3> : unfilterRow<4>;
    Rows rows(png);
    if (!rows.unpack(png.packed)) return {};
    const std::vector<std::uint8_t> nothing(std::size_t{4} * png.width);
    const std::uint8_t *above = nothing.data(), *in = rows.first();
    std::uint8_t* out = rows.memory().data();
    for (std::uint32_t y = 0; y < png.height; ++y) {
        if (!unfilterAnyRow(in, above, png.width, out)) return {};
        above = out;
        in += 1 + png.rowBytes();
        out += std::size_t{4} * png.width;
    }
    rows.memory().resize(std::size_t{4} * png.width * png.height);
    if (png.channels == 3) makeOpaque(rows.memory());
    return Image{.width = static_cast<int>(png.width),
                 .height = static_cast<int>(png.height),
                 .hasAlpha = png.channels == 4,
                 .rgba = std::move(rows.memory())};
}

}  // namespace walkcycle
