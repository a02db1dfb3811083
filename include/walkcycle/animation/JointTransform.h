#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <walkcycle/Export.h>

namespace walkcycle {

// The library is compiled with GLM's default layout. With another, a program would read other numbers than it wrote.
static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && alignof(glm::mat4) == alignof(float),
              "Walkcycle needs GLM without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES");
#if defined(GLM_FORCE_QUAT_DATA_WXYZ) || defined(GLM_FORCE_QUAT_DATA_XYZW)
#error "Walkcycle needs GLM without GLM_FORCE_QUAT_DATA_..."
#endif

// The transform of a joint relative to its parent: first scaled, then rotated, then moved.
// (The series' JointTransform, completed by scale.)
template <typename Number>
struct WALKCYCLE_API BasicJointTransform {
    glm::vec<3, Number> position{Number(0)};                                // in the parent's space and units
    glm::qua<Number> rotation{Number(1), Number(0), Number(0), Number(0)};  // w, x, y, z; of unit length
    glm::vec<3, Number> scale{Number(1)};

    glm::mat<4, 4, Number> toMatrix() const;  // translation * rotation * scale

    // The transform at `progression` (0 gives a, 1 gives b) of the way from a to b: position and scale are blended
    // linearly, the rotation by slerp (the short way round, at constant speed).
    static BasicJointTransform interpolate(const BasicJointTransform& a, const BasicJointTransform& b,
                                           Number progression);

    // The same transform in another precision.
    template <typename Other>
    explicit operator BasicJointTransform<Other>() const {
        return {glm::vec<3, Other>(position), glm::qua<Other>(rotation), glm::vec<3, Other>(scale)};
    }
};

using JointTransform = BasicJointTransform<float>;   // of key frames and poses
using ExactTransform = BasicJointTransform<double>;  // of a file's curves, before they become key frames

}  // namespace walkcycle
