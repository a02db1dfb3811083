#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace walkcycle {

// Where a joint stands relative to its parent joint: first scaled, then turned, then moved.
// (The series' JointTransform, completed by scale.)
struct JointTransform {
    glm::vec3 position{0.0f};                    // in the parent's space and units
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  // w, x, y, z; of unit length
    glm::vec3 scale{1.0f};

    glm::mat4 toMatrix() const;

    // The transform at `progression` (0 gives a, 1 gives b) of the way from a to b: positions and scales on a
    // straight line, rotations the short way round at constant speed.
    static JointTransform interpolate(const JointTransform& a, const JointTransform& b, float progression);
};

}  // namespace walkcycle
