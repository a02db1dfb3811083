#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace walkcycle {

// An affine matrix as translate * rotate * stretch, exactly. The stretch is the diagonal of the scales where the
// matrix has no shear; mirroring shows as a negative first scale.
struct MatrixParts {
    glm::dvec3 position{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dmat3 stretch{1.0};

    glm::dmat4 toMatrix() const;
    glm::dvec3 scale() const { return {stretch[0][0], stretch[1][1], stretch[2][2]}; }
    bool turns = true;  // false: flattened so far that its rotation is a guess (that of `near`)
};

// `near` decides what the matrix leaves open: the rotation of axes that are scaled to nothing, and which of the two
// quaternions of a rotation.
MatrixParts partsOf(const glm::dmat4& matrix, const glm::dquat& near = {1.0, 0.0, 0.0, 0.0});

// What every program does between two LINEAR matrix keys: positions and stretches on a straight line, rotations the
// short way round at constant speed.
MatrixParts blend(const MatrixParts& a, const MatrixParts& b, double progression);

}  // namespace walkcycle
