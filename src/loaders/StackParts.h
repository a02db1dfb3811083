#pragma once

#include "loaders/MatrixParts.h"
#include "loaders/Motion.h"

namespace walkcycle {

// The parts of a moving joint's transform, taken from its stack without a matrix on the way.
class StackParts {
public:
    explicit StackParts(const JointMotion& motion);  // of which JointMotion::hasPlainStack() is true

    // False where a scale is not above zero: only the matrix tells what is mirrored or flat.
    bool at(double seconds, Side side, MatrixParts& parts);

private:
    struct Step {
        TransformElement::Kind kind;
        std::array<double, 4> values;
        glm::dquat rotation;            // of one that does not move
        std::size_t binding, bindings;  // the first of those that move it, and how many there are
    };
    struct Moved {
        CurveBinding binding;
        std::size_t place = 0;  // the curve's segment that was asked for last
    };
    void move(const Step& step, double seconds, Side side, std::array<double, 4>& values);

    std::vector<Step> steps_;
    std::vector<Moved> moved_;  // those of each step together, in their order
};

}  // namespace walkcycle
