#pragma once

#include "animation/Interpolation.h"
#include "animation/JointTransform.h"

namespace walkcycle {

// How fast the numbers of a transform change.
template <typename Number>
struct TransformRates {
    glm::vec<3, Number> position{Number(0)};
    glm::qua<Number> rotation{Number(0), Number(0), Number(0), Number(0)};
    glm::vec<3, Number> scale{Number(0)};
};

// Each number of position, rotation and scale on a cubic curve, the rotation brought back to unit length.
template <typename Number>
BasicJointTransform<Number> curvedTransform(const BasicJointTransform<Number>& a,
                                            const TransformRates<Number>& leaving,
                                            const BasicJointTransform<Number>& b,
                                            const TransformRates<Number>& arriving,
                                            const Hermite<Number>& at) {
    return {at.value(a.position, leaving.position, b.position, arriving.position),
            glm::normalize(at.value(a.rotation, leaving.rotation, b.rotation, arriving.rotation)),
            at.value(a.scale, leaving.scale, b.scale, arriving.scale)};
}

}  // namespace walkcycle
