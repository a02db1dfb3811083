#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace walkcycle {

// An affine matrix as the product translate * rotate * stretch, without loss. A matrix without shear has a
// diagonal stretch: its scales. If the matrix mirrors, the first scale is negative.
struct MatrixParts {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dmat3 stretch{1.0};

    glm::dmat4 toMatrix() const;
    glm::dvec3 scale() const { return {stretch[0][0], stretch[1][1], stretch[2][2]}; }
    bool hasRotation = true;  // false: two or more axes are scaled to nothing, and the rotation is a guess
};

// Decomposes a matrix. `near` decides what the matrix does not determine: the direction of axes that are
// scaled to nothing, and which of the two quaternions of the rotation (q or -q) is taken.
MatrixParts partsOf(const glm::dmat4& matrix, const glm::dquat& near = {1.0, 0.0, 0.0, 0.0});

// Blends two matrices as programs do between LINEAR keys: position and stretch linearly, the rotation by
// slerp.
MatrixParts blend(const MatrixParts& a, const MatrixParts& b, double progression);

}  // namespace walkcycle
