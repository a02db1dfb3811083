#pragma once

#include <cmath>
#include <type_traits>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "walkcycle/animation/Joint.h"

namespace walkcycle {

// The transform that a skin's node applies on top of the joints (see Skin::placedBy, which must be a joint):
// modelTransform(placedBy) * inverse(modelTransform(placedRelativeTo)), in the precision of modelTransform().
template <typename Placed, typename ModelTransform>
auto skinPlacement(const Placed& skin, ModelTransform modelTransform) {
    using Matrix = std::remove_cvref_t<decltype(modelTransform(skin.placedBy))>;
    const Matrix meetingPoint = skin.placedRelativeTo == kNoParent ? Matrix(skin.placedInRoot)
                                                                   : modelTransform(skin.placedRelativeTo);
    // If the ancestor has no inverse, its scale is zero and nothing is visible: any matrix will do.
    if (!std::isnormal(glm::determinant(meetingPoint))) return Matrix(1);
    return modelTransform(skin.placedBy) * glm::inverse(meetingPoint);
}

// A matrix without an inverse has a zero scale, so that nothing is visible: any matrix will do.
template <typename Matrix>
Matrix inverseOrIdentity(const Matrix& matrix) {
    return std::isnormal(glm::determinant(matrix)) ? glm::inverse(matrix) : Matrix(1);
}

}  // namespace walkcycle
