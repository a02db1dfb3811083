#include "animation/JointTransform.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace walkcycle {
namespace {

float lengthOf(const glm::quat& q) {
    return std::sqrt(glm::dot(q, q));
}

// Both of unit length. The angle comes from a sum and a difference: unlike the arc cosine of a dot product,
// that stays exact for rotations that hardly differ.
glm::quat slerp(const glm::quat& a, const glm::quat& b, float progression) {
    // q and -q are the same rotation; flip one so that the blend takes the short way round.
    const glm::quat nearest = glm::dot(a, b) < 0.0f ? -b : b;
    const float angle = 2.0f * std::atan2(lengthOf(nearest - a), lengthOf(nearest + a));
    if (angle < 1e-4f) return glm::normalize(a * (1.0f - progression) + nearest * progression);
    const float fromA = std::sin((1.0f - progression) * angle);
    const float fromB = std::sin(progression * angle);
    return glm::normalize(a * fromA + nearest * fromB);
}

}  // namespace

// glm::mat3_cast takes the quaternion's length for exactly 1; the little that rounding makes of it would scale each
// joint of a long chain.
glm::mat4 JointTransform::toMatrix() const {
    const glm::quat& q = rotation;
    const glm::vec3 twice = glm::vec3(q.x, q.y, q.z) * (2.0f / glm::dot(q, q));
    const float xx = q.x * twice.x, yy = q.y * twice.y, zz = q.z * twice.z;
    const float xy = q.x * twice.y, xz = q.x * twice.z, yz = q.y * twice.z;
    const float wx = q.w * twice.x, wy = q.w * twice.y, wz = q.w * twice.z;
    const glm::mat3 turn(1.0f - (yy + zz), xy + wz, xz - wy,  // a column each
                         xy - wz, 1.0f - (xx + zz), yz + wx,  //
                         xz + wy, yz - wx, 1.0f - (xx + yy));
    return {glm::vec4(turn[0] * scale.x, 0.0f), glm::vec4(turn[1] * scale.y, 0.0f),
            glm::vec4(turn[2] * scale.z, 0.0f), glm::vec4(position, 1.0f)};
}

JointTransform JointTransform::interpolate(const JointTransform& a, const JointTransform& b,
                                           float progression) {
    return {.position = a.position + (b.position - a.position) * progression,
            .rotation = slerp(a.rotation, b.rotation, progression),
            .scale = a.scale + (b.scale - a.scale) * progression};
}

}  // namespace walkcycle
