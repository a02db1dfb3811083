#include "animation/Skin.h"

#include <cassert>
#include <cmath>
#include <cstddef>

#include <glm/matrix.hpp>

namespace walkcycle {
namespace {

// What the skin's node adds to the joints' own transforms.
glm::mat4 placement(const Skin& skin, const std::vector<glm::mat4>& modelTransforms) {
    const glm::mat4& meetingPoint = skin.placedRelativeTo == kNoParent
                                        ? skin.placedInRoot
                                        : modelTransforms[static_cast<std::size_t>(skin.placedRelativeTo)];
    // An ancestor scaled to nothing leaves nothing to see, and has no inverse.
    const float determinant = glm::determinant(meetingPoint);
    if (!std::isnormal(determinant)) return glm::mat4(1.0f);
    return modelTransforms[static_cast<std::size_t>(skin.placedBy)] * glm::inverse(meetingPoint);
}

}  // namespace

void computePalette(const Skin& skin, const std::vector<glm::mat4>& modelTransforms,
                    std::vector<glm::mat4>& palette) {
    assert(skin.inverseBindMatrices.size() == skin.joints.size());
    palette.resize(skin.joints.size());
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const auto joint = static_cast<std::size_t>(skin.joints[i]);
        palette[i] = modelTransforms[joint] * (skin.inverseBindMatrices[i] * skin.bindShapeMatrix);
    }
    if (skin.placedBy == kNoParent) return;
    const glm::mat4 placed = placement(skin, modelTransforms);
    for (std::size_t i = 0; i + 1 < palette.size(); ++i) palette[i] = placed * palette[i];
}

}  // namespace walkcycle
