#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// Gives a picture more samples per pixel than the device has: computes the mean of several pictures (passes) of one
// moment, each with the camera shifted by another fraction of a pixel.
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

    // The shift of a pass for Camera::shifted(): in pixels, to the right and up. If the device has four samples per
    // pixel, the samples of all passes together are evenly spaced in both directions.
    glm::vec2 offset(int pass) const;

    void add(const Image& picture);  // with straight alpha; all pictures have the same size
    Image image() const;             // the mean, with straight alpha

private:
    int passes_;
    int width_ = 0, height_ = 0;
    std::vector<float> light_;  // premultiplied, linear; red, green, blue and alpha in 0..1, summed
};

}  // namespace walkcycle
