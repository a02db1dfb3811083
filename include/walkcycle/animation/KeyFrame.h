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

// How fast the numbers of a transform change.
template <typename Number>
struct TransformRates {
    glm::vec<3, Number> position{Number(0)};
    glm::qua<Number> rotation{Number(0), Number(0), Number(0), Number(0)};
    glm::vec<3, Number> scale{Number(0)};
};

// How fast the numbers of a transform change as they arrive at a key frame and as they leave it, per second. With
// tangents, each number runs on a cubic curve from key frame to key frame (glTF's CUBICSPLINE).
struct KeyTangents {
    using Rates = TransformRates<float>;
    Rates in, out;
};

// A key frame for what no JointTransform can hold: animated shear, mirroring, zero scale.
struct MatrixKeyFrame {
    double seconds = 0.0;
    glm::mat4 matrix{1.0f};
    bool step = false;  // holds until the next key frame
};

// A single number that moves: a morph weight, a light's intensity, a colour's red.
struct ParameterKeyFrame {
    double seconds = 0.0;
    float value = 0.0f;
    bool step = false;  // holds until the next key frame
};

}  // namespace walkcycle
