#include "render/ScreenArea.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>

namespace walkcycle {

std::vector<Bounds> boxesOfMatrices(const MeshData& mesh, const Influences* influences,
                                    std::size_t matrices) {
    std::vector<Bounds> boxes(matrices);
    for (std::size_t p = 0; p < mesh.positions.size(); ++p) {
        if (!influences) {
            boxes.front().add(mesh.positions[p]);
            continue;
        }
        if (influences->first[p] == influences->first[p + 1]) return {};
        for (std::uint32_t i = influences->first[p]; i < influences->first[p + 1]; ++i) {
            const Influence& influence = influences->influences[i];
            if (influence.weight < 0.0f || influence.joint >= matrices) return {};
            boxes[influence.joint].add(mesh.positions[p]);
        }
    }
    return boxes;
}

ScreenArea ScreenArea::none(int width, int height) {
    ScreenArea area;
    area.width_ = width;
    area.height_ = height;
    return area;
}

void ScreenArea::add(const Bounds& box, const glm::mat4& toClip) {
    if (box.empty() || width_ == 0) return;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                              corner & 4 ? box.max.z : box.min.z);
        const glm::vec4 clip = toClip * glm::vec4(point, 1.0f);
        if (!(clip.w > 1e-6f)) {
            *this = whole();
            return;
        }
        const glm::vec2 onPicture = glm::clamp(glm::vec2(clip) / clip.w, -2.0f, 2.0f);
        min_ = glm::min(min_, onPicture);
        max_ = glm::max(max_, onPicture);
    }
}

glm::ivec4 ScreenArea::pixels() const {
    if (width_ == 0) return {0, 0, INT_MAX, INT_MAX};
    if (min_.x > max_.x) return {0, 0, 0, 0};  // nothing was drawn
    const auto pixel = [](float place, int size, int margin) {
        const float at = std::floor((place * 0.5f + 0.5f) * static_cast<float>(size));
        return std::clamp(static_cast<int>(at) + margin, 0, size - 1);
    };
    constexpr int kMargin = 3;  // for the width of lines and the spread of samples, plus one clear pixel
    return {pixel(min_.x, width_, -kMargin), pixel(min_.y, height_, -kMargin), pixel(max_.x, width_, kMargin),
            pixel(max_.y, height_, kMargin)};
}

}  // namespace walkcycle
