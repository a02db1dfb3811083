#include "walkcycle/animation/JointTransform.h"

#include <glm/mat3x3.hpp>

#include "animation/Interpolation.h"

namespace walkcycle {

// Not glm::mat3_cast: it assumes a quaternion of exactly unit length, and the rounding error of the length would scale
// every joint of a long chain.
template <typename Number>
glm::mat<4, 4, Number> BasicJointTransform<Number>::toMatrix() const {
    const glm::qua<Number>& q = rotation;
    const Number one(1);
    const glm::vec<3, Number> twice = glm::vec<3, Number>(q.x, q.y, q.z) * (Number(2) / glm::dot(q, q));
    const Number xx = q.x * twice.x, yy = q.y * twice.y, zz = q.z * twice.z;
    const Number xy = q.x * twice.y, xz = q.x * twice.z, yz = q.y * twice.z;
    const Number wx = q.w * twice.x, wy = q.w * twice.y, wz = q.w * twice.z;
    const glm::mat<3, 3, Number> rotated(one - (yy + zz), xy + wz, xz - wy,  // a column each
                                         xy - wz, one - (xx + zz), yz + wx,  //
                                         xz + wy, yz - wx, one - (xx + yy));
    using Column = glm::vec<4, Number>;
    return {Column(rotated[0] * scale.x, Number(0)), Column(rotated[1] * scale.y, Number(0)),
            Column(rotated[2] * scale.z, Number(0)), Column(position, one)};
}

template <typename Number>
BasicJointTransform<Number> BasicJointTransform<Number>::interpolate(const BasicJointTransform& a,
                                                                     const BasicJointTransform& b,
                                                                     Number progression) {
    return {.position = a.position + (b.position - a.position) * progression,
            .rotation = Slerp(a.rotation, b.rotation).at(progression),
            .scale = a.scale + (b.scale - a.scale) * progression};
}

template struct BasicJointTransform<float>;
template struct BasicJointTransform<double>;

}  // namespace walkcycle
