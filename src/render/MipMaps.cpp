#include "render/MipMaps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "render/Srgb.h"

namespace walkcycle {
namespace {

// Light has 14 bits, so that the sum of four texels has 16.
constexpr std::uint32_t kFullLight = 16383;

struct Tables {
    std::array<std::uint16_t, 256> light;               // byte -> light, 0 to kFullLight
    std::array<std::uint8_t, 4 * kFullLight + 1> byte;  // sum of four lights -> nearest byte of their mean

    explicit Tables(TexelKind kind) {
        for (std::size_t i = 0; i < 256; ++i) {
            const auto value = static_cast<float>(i) / 255.0f;
            const float linear = kind == TexelKind::Color ? linearOfSrgb(value) : value;
            light[i] = static_cast<std::uint16_t>(linear * kFullLight + 0.5f);
        }
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < byte.size(); ++i) {
            while (nearest < 255 && 2 * i > 4u * (light[nearest] + std::size_t{light[nearest + 1]}))
                ++nearest;
            byte[i] = static_cast<std::uint8_t>(nearest);
        }
    }
};

template <TexelKind kind>
const Tables& tablesOf() {
    static const auto instance = std::make_unique<const Tables>(kind);
    return *instance;
}

const Tables& tables(TexelKind kind) {
    return kind == TexelKind::Color ? tablesOf<TexelKind::Color>() : tablesOf<TexelKind::Data>();
}

// The texels [first, last) of a row or column that the smaller picture's texel `i` covers: two, or three at
// odd sizes.
struct Span {
    std::size_t first, last;
};
Span covered(std::size_t i, std::size_t large, std::size_t small) {
    return {i * large / small, ((i + 1) * large + small - 1) / small};
}

// Writes the mean of a block of texels to `out`, weighted by alpha; unweighted if all are transparent.
void average(const Image& image, Span rows, Span columns, const Tables& t, std::uint8_t* out) {
    std::uint64_t weights = 0, light[3] = {0, 0, 0}, plain[3] = {0, 0, 0};
    for (std::size_t y = rows.first; y < rows.last; ++y) {
        for (std::size_t x = columns.first; x < columns.last; ++x) {
            const std::uint8_t* texel = &image.rgba[(y * static_cast<std::size_t>(image.width) + x) * 4];
            weights += texel[3];
            for (std::size_t c = 0; c < 3; ++c) {
                light[c] += std::uint64_t{t.light[texel[c]]} * texel[3];
                plain[c] += t.light[texel[c]];
            }
        }
    }
    const std::uint64_t count = (rows.last - rows.first) * (columns.last - columns.first);
    for (std::size_t c = 0; c < 3; ++c) {
        out[c] = t.byte[weights ? 4 * light[c] / weights : 4 * plain[c] / count];
    }
    out[3] = static_cast<std::uint8_t>((weights + count / 2) / count);
}

// A row of a picture whose width and height are even, the common case. If four texels have the same alpha, it needs no
// weights.
void averageRow(const Image& image, std::size_t y, const Tables& t, std::uint8_t* out) {
    const auto stride = static_cast<std::size_t>(image.width) * 4;
    const std::uint8_t *upper = &image.rgba[2 * y * stride], *lower = upper + stride;
    for (std::size_t x = 0; x < stride / 8; ++x, upper += 8, lower += 8, out += 4) {
        if (upper[3] != upper[7] || upper[3] != lower[3] || upper[3] != lower[7]) {
            average(image, {2 * y, 2 * y + 2}, {2 * x, 2 * x + 2}, t, out);
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            out[c] = t.byte[std::size_t{t.light[upper[c]]} + t.light[upper[c + 4]] + t.light[lower[c]] +
                            t.light[lower[c + 4]]];
        }
        out[3] = upper[3];
    }
}

}  // namespace

Image halved(const Image& image, TexelKind kind) {
    const Tables& t = tables(kind);
    Image half;
    half.width = std::max(1, image.width / 2);
    half.height = std::max(1, image.height / 2);
    half.hasAlpha = image.hasAlpha;
    const auto width = static_cast<std::size_t>(half.width), height = static_cast<std::size_t>(half.height);
    const auto sourceWidth = static_cast<std::size_t>(image.width);
    const bool even = image.width % 2 == 0 && image.height % 2 == 0;
    half.rgba.resize(width * height * 4);
    for (std::size_t y = 0; y < height; ++y) {
        std::uint8_t* out = &half.rgba[y * width * 4];
        if (even) {
            averageRow(image, y, t, out);
            continue;
        }
        const Span rows = covered(y, static_cast<std::size_t>(image.height), height);
        for (std::size_t x = 0; x < width; ++x)
            average(image, rows, covered(x, sourceWidth, width), t, out + x * 4);
    }
    return half;
}

std::vector<Image> mipMaps(const Image& image, TexelKind kind) {
    std::vector<Image> levels;
    const Image* last = &image;
    while (last->width > 1 || last->height > 1) {
        levels.push_back(halved(*last, kind));
        last = &levels.back();
    }
    return levels;
}

}  // namespace walkcycle
