#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <walkcycle/animation/JointTransform.h>

namespace walkcycle {

// A joint's transform at one time of the document's timeline.
struct KeyFrame {
    double seconds = 0.0;
    JointTransform transform{};
    bool step = false;  // holds until the next key frame, instead of blending into it
};

// How fast each number of a transform changes (its derivative), component by component.
template <typename Number>
struct TransformRates {
    glm::vec<3, Number> position{Number(0)};
    glm::qua<Number> rotation{Number(0), Number(0), Number(0), Number(0)};
    glm::vec<3, Number> scale{Number(0)};
};

// How fast a transform changes, per second: as it arrives at a key frame (`in`) and as it leaves it (`out`). With
// tangents, each number follows a cubic Hermite curve from key frame to key frame (glTF's CUBICSPLINE).
struct KeyTangents {
    using Rates = TransformRates<float>;
    Rates in, out;
};

// A key frame for a motion that no JointTransform can hold: animated shear, mirroring, zero scale.
struct MatrixKeyFrame {
    double seconds = 0.0;
    glm::mat4 matrix{1.0f};
    bool step = false;  // holds until the next key frame
};

// A key frame of a single number: a morph weight, a light's intensity, the red of a colour.
struct ParameterKeyFrame {
    double seconds = 0.0;
    float value = 0.0f;
    bool step = false;  // holds until the next key frame
};

}  // namespace walkcycle
