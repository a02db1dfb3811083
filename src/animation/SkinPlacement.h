#pragma once

#include <cmath>
#include <type_traits>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "walkcycle/animation/Joint.h"

namespace walkcycle {

// What the skin's node adds to the joints' own transforms, of a Skin that its node places (see Skin::placedBy):
// modelTransform(placedBy) * inverse(modelTransform(placedRelativeTo)), in float or double as modelTransform() gives them.
template <typename Placed, typename ModelTransform>
auto skinPlacement(const Placed& skin, ModelTransform modelTransform) {
    using Matrix = std::remove_cvref_t<decltype(modelTransform(skin.placedBy))>;
    const Matrix meetingPoint = skin.placedRelativeTo == kNoParent ? Matrix(skin.placedInRoot)
                                                                   : modelTransform(skin.placedRelativeTo);
    // An ancestor scaled to nothing leaves nothing to see, and has no inverse.
    if (!std::isnormal(glm::determinant(meetingPoint))) return Matrix(1);
    return modelTransform(skin.placedBy) * glm::inverse(meetingPoint);
}

// Where a matrix has no inverse, because it scales to nothing, there is nothing to see: any matrix will do.
template <typename Matrix>
Matrix inverseOrIdentity(const Matrix& matrix) {
    return std::isnormal(glm::determinant(matrix)) ? glm::inverse(matrix) : Matrix(1);
}

}  // namespace walkcycle
