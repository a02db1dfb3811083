#include "app/ImageDifference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

namespace walkcycle {
namespace {

// Red, green and blue times alpha, and alpha.
std::array<int, 4> premultiplied(const Image& image, std::size_t pixel) {
    const std::uint8_t* p = image.rgba.data() + pixel * 4;
    return {p[0] * p[3] / 255, p[1] * p[3] / 255, p[2] * p[3] / 255, p[3]};
}

std::vector<double> brightness(const Image& image) {
    std::vector<double> values(image.rgba.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::array<int, 4> p = premultiplied(image, i);
        values[i] = 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
    }
    return values;
}

// The constants of structural similarity (Wang, Bovik, Sheikh and Simoncelli, "Image Quality Assessment", 2004), over
// windows of 8 x 8 pixels, one every 4 pixels.
constexpr int kWindow = 8, kStep = 4;
constexpr double kC1 = (0.01 * 255) * (0.01 * 255), kC2 = (0.03 * 255) * (0.03 * 255);

struct Sums {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0, count = 0;

    void add(double x, double y) { a += x, b += y, aa += x * x, bb += y * y, ab += x * y, count += 1; }
    double similarity() const {
        const double meanA = a / count, meanB = b / count;
        const double varianceA = aa / count - meanA * meanA, varianceB = bb / count - meanB * meanB;
        const double covariance = ab / count - meanA * meanB;
        return (2 * meanA * meanB + kC1) * (2 * covariance + kC2) /
               ((meanA * meanA + meanB * meanB + kC1) * (varianceA + varianceB + kC2));
    }
};

double structuralSimilarity(const Image& a, const Image& b) {
    const std::vector<double> x = brightness(a), y = brightness(b);
    double sum = 0.0;
    int windows = 0;
    for (int top = 0; top == 0 || top + kWindow <= a.height; top += kStep)
        for (int left = 0; left == 0 || left + kWindow <= a.width; left += kStep) {
            Sums sums;
            for (int row = top; row < std::min(top + kWindow, a.height); ++row)
                for (int column = left; column < std::min(left + kWindow, a.width); ++column) {
                    const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(a.width) +
                                   static_cast<std::size_t>(column);
                    sums.add(x[i], y[i]);
                }
            sum += sums.similarity();
            ++windows;
        }
    return sum / windows;
}

}  // namespace

ImageDifference compare(const Image& a, const Image& b) {
    ImageDifference result;
    result.picture = {.width = a.width, .height = a.height, .hasAlpha = false, .rgba = {}};
    result.picture.rgba.resize(a.rgba.size());
    double squares = 0.0;
    const std::size_t pixels = a.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::array<int, 4> x = premultiplied(a, i), y = premultiplied(b, i);
        result.pixels += x != y;
        for (std::size_t c = 0; c < 4; ++c) {
            const int difference = std::abs(x[c] - y[c]);
            squares += difference * difference;
            const int shown = std::max(difference, std::abs(x[3] - y[3]));
            result.picture.rgba[i * 4 + c] =
                c == 3 ? 255 : static_cast<std::uint8_t>(std::min(255, shown * 4));
        }
    }
    result.rmse = std::sqrt(squares / static_cast<double>(pixels * 4)) / 255.0;
    result.psnr =
        result.rmse > 0.0 ? -20.0 * std::log10(result.rmse) : std::numeric_limits<double>::infinity();
    result.ssim = structuralSimilarity(a, b);
    return result;
}

}  // namespace walkcycle
