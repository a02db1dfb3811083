#pragma once

#include <cstdint>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// How much two pictures of the same size differ. Colours are multiplied by their alpha, as if drawn over black.
struct ImageDifference {
    std::int64_t pixels = 0;  // ae, absolute error: the number of pixels that differ
    double rmse = 0.0;        // root of the mean squared difference, 0 to 1
    double psnr = 0.0;        // peak signal-to-noise ratio in decibels; infinite for equal pictures
    double ssim = 0.0;        // structural similarity of the brightness, 1 for equal pictures
    Image picture;            // the differences, four times as bright, on black
};

ImageDifference compare(const Image& a, const Image& b);

}  // namespace walkcycle
