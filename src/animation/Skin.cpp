#include "walkcycle/animation/Skin.h"

#include <cassert>
#include <cstddef>

#include "animation/SkinPlacement.h"

namespace walkcycle {
namespace {

template <class Matrix>
void fillPalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms, std::span<Matrix> palette) {
    assert(skin.bindMatrices.size() == skin.joints.size() && palette.size() == skin.joints.size());
    const auto modelTransform = [&](int joint) -> const glm::mat4& {
        return modelTransforms[static_cast<std::size_t>(joint)];
    };
    const bool isPlaced = skin.placedBy != kNoParent;
    const glm::mat4 placement = isPlaced ? skinPlacement(skin, modelTransform) : glm::mat4(1.0f);
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const glm::mat4 matrix = modelTransform(skin.joints[i]) * skin.bindMatrices[i];
        const bool isNode = i + 1 == palette.size();
        palette[i] = Matrix(isPlaced && !isNode ? placement * matrix : matrix);
    }
}

}  // namespace

void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                    std::vector<glm::mat4>& palette) {
    palette.resize(skin.joints.size());
    fillPalette(skin, modelTransforms, std::span(palette));
}

void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                    std::span<JointRows> palette) {
    fillPalette(skin, modelTransforms, palette);
}

}  // namespace walkcycle
