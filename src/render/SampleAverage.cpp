#include "render/SampleAverage.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/Srgb.h"

namespace walkcycle {

glm::vec2 SampleAverage::offset(int pass) const {
    // The device's own four samples are a quarter of a pixel apart in x and in y. The shifts of the passes
    // divide that quarter evenly; their order in y differs, so that the samples do not lie on one line.
    const int other = (pass * 3 + 1) % passes_;
    const auto share = [this](int index) {
        return ((static_cast<float>(index) + 0.5f) / static_cast<float>(passes_) - 0.5f) * 0.25f;
    };
    return {share(pass), share(passes_ % 3 == 0 ? passes_ - 1 - pass : other)};
}

void SampleAverage::add(const Image& picture) {
    width_ = picture.width;
    height_ = picture.height;
    light_.resize(picture.rgba.size());
    for (std::size_t i = 0; i < light_.size(); i += 4) {
        const float alpha = static_cast<float>(picture.rgba[i + 3]) / 255.0f;
        for (std::size_t c = 0; c < 3; ++c) light_[i + c] += linearOfSrgb(picture.rgba[i + c]) * alpha;
        light_[i + 3] += alpha;
    }
}

Image SampleAverage::image() const {
    Image picture;
    picture.width = width_;
    picture.height = height_;
    picture.hasAlpha = true;
    picture.rgba.resize(light_.size());
    const float passes = static_cast<float>(passes_);
    for (std::size_t i = 0; i < light_.size(); i += 4) {
        const float alpha = light_[i + 3];
        for (std::size_t c = 0; c < 3; ++c)
            picture.rgba[i + c] = alpha > 0.0f ? srgbOfLinear(light_[i + c] / alpha) : std::uint8_t{0};
        picture.rgba[i + 3] = static_cast<std::uint8_t>(std::lround(alpha / passes * 255.0f));
    }
    return picture;
}

}  // namespace walkcycle
