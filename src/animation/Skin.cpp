#include "animation/Skin.h"

#include <cassert>
#include <cstddef>

#include "animation/SkinPlacement.h"

namespace walkcycle {

void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                    std::vector<glm::mat4>& palette) {
    assert(skin.inverseBindMatrices.size() == skin.joints.size());
    palette.resize(skin.joints.size());
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const auto joint = static_cast<std::size_t>(skin.joints[i]);
        palette[i] = modelTransforms[joint] * (skin.inverseBindMatrices[i] * skin.bindShapeMatrix);
    }
    if (skin.placedBy == kNoParent) return;
    const glm::mat4 placed =
        skinPlacement(skin, [&](int joint) { return modelTransforms[static_cast<std::size_t>(joint)]; });
    for (std::size_t i = 0; i + 1 < palette.size(); ++i) palette[i] = placed * palette[i];
}

}  // namespace walkcycle
