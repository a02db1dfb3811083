#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "io/Image.h"

namespace walkcycle {

// More samples a pixel than the device has: the mean of several pictures of one moment, each seen by a camera shifted
// by a fraction of a pixel.
//
//     SampleAverage average(4);
//     for (int pass = 0; pass < 4; ++pass) {
//         renderer.render(model, camera.shifted(average.offset(pass), picture.width(), picture.height()), picture);
//         average.add(picture.read());
//     }
//     savePng(average.image(), "smooth.png");
class SampleAverage {
public:
    explicit SampleAverage(int passes) : passes_(passes) {}

    // Where pass p looks, in pixels to the right and up: with four samples of the device's own, those of all passes
    // together stand at even distances in both directions.
    glm::vec2 offset(int pass) const;

    void add(const Image& picture);  // straight alpha, all of one size
    Image image() const;

private:
    int passes_;
    int width_ = 0, height_ = 0;
    std::vector<float> light_;  // premultiplied, linear; red, green, blue and alpha in 0..1, summed
};

}  // namespace walkcycle
