#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace walkcycle {

// An affine matrix as the product translate * rotate * stretch, without loss. Without shear, the stretch is a diagonal
// matrix of the scales. A mirrored matrix has a negative first scale.
struct MatrixParts {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dmat3 stretch{1.0};

    glm::dmat4 toMatrix() const;
    glm::dvec3 scale() const { return {stretch[0][0], stretch[1][1], stretch[2][2]}; }
    bool hasRotation = true;  // false if two axes or more are scaled to nothing; then the rotation is a guess
};

// Decomposes a matrix. `near` decides what the matrix leaves open: the direction of axes that are scaled to nothing, and
// which of the two quaternions of a rotation is taken.
MatrixParts partsOf(const glm::dmat4& matrix, const glm::dquat& near = {1.0, 0.0, 0.0, 0.0});

// The matrix between two LINEAR matrix keys, as all programs have it: position and stretch on a straight line, rotation
// by slerp.
MatrixParts blend(const MatrixParts& a, const MatrixParts& b, double progression);

}  // namespace walkcycle
