#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "loaders/curves/MatrixParts.h"
#include "loaders/curves/Motion.h"

namespace walkcycle {

// Position, rotation and scale of a moving joint, computed from its plain transform stack. Faster than
// decomposing its matrix.
class StackParts {
public:
    explicit StackParts(const JointMotion& motion);  // requires motion.hasPlainStack()

    // Returns false if a scale is not positive. Then the matrix must be decomposed instead.
    bool at(double seconds, Side side, MatrixParts& parts);

private:
    struct Step {
        TransformElement::Kind kind;
        std::array<double, 4> values;
        glm::dquat rotation;            // if it is a <rotate> that no curve moves
        std::size_t binding, bindings;  // index of its first entry in moved_, and number of entries
    };
    struct Moved {
        CurveBinding binding;
        std::size_t hint = 0;  // of Curve::evaluate()
    };
    void move(const Step& step, double seconds, Side side, std::array<double, 4>& values);

    std::vector<Step> steps_;
    std::vector<Moved> moved_;  // sorted by step
};

}  // namespace walkcycle
