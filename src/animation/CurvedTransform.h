#pragma once

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "animation/Interpolation.h"
#include "walkcycle/animation/KeyFrame.h"

namespace walkcycle {

// Each number of position, rotation and scale on its cubic Hermite curve from a to b; the rotation is normalised.
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
