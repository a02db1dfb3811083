#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "loaders/curves/MatrixParts.h"
#include "loaders/curves/Motion.h"

namespace walkcycle {

// Position, rotation and scale of a moving joint, from its plain transform stack. Faster than to decompose its matrix.
class StackParts {
public:
    explicit StackParts(const JointMotion& motion);  // of which JointMotion::hasPlainStack() is true

    // Returns false if a scale is not positive: what is mirrored or flat, only the matrix tells.
    bool at(double seconds, Side side, MatrixParts& parts);

private:
    struct Step {
        TransformElement::Kind kind;
        std::array<double, 4> values;
        glm::dquat rotation;            // of a <rotate> that no curve moves
        std::size_t binding, bindings;  // the first of the bindings that move it, and their number
    };
    struct Moved {
        CurveBinding binding;
        std::size_t hint = 0;  // of Curve::evaluate()
    };
    void move(const Step& step, double seconds, Side side, std::array<double, 4>& values);

    std::vector<Step> steps_;
    std::vector<Moved> moved_;  // step by step
};

}  // namespace walkcycle
