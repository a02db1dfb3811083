#pragma once

#include <cstdint>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// How much two pictures of the same size differ. Colours are multiplied by their alpha, as if over black.
struct ImageDifference {
    std::int64_t pixels = 0;  // ae: how many pixels differ at all
    double rmse = 0.0;        // root of the mean squared difference, 0 to 1
    double psnr = 0.0;        // in decibels; infinite for equal pictures
    double ssim = 0.0;        // structural similarity of the brightness, 1 for equal pictures
    Image picture;            // the differences, bright on black
};

ImageDifference compare(const Image& a, const Image& b);

}  // namespace walkcycle
