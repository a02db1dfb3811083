#pragma once

#include "animation/JointTransform.h"

namespace walkcycle {

// A joint's transform at one time of the document's timeline.
struct KeyFrame {
    double seconds = 0.0;
    JointTransform transform{};
    bool step = false;  // holds until the next key, instead of blending into it
};

// For what no JointTransform can hold: animated shear, mirroring, zero scale. Blended number by number.
struct MatrixKeyFrame {
    double seconds = 0.0;
    glm::mat4 matrix{1.0f};
    bool step = false;
};

// A single number that moves: a morph weight, a light's intensity, a colour's red.
struct ParameterKeyFrame {
    double seconds = 0.0;
    float value = 0.0f;
    bool step = false;
};

}  // namespace walkcycle
