#include "loaders/curves/StackParts.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <glm/trigonometric.hpp>

namespace walkcycle {

namespace {

using Kind = TransformElement::Kind;

glm::dquat rotationOf(const std::array<double, 4>& values) {
    const glm::dvec3 axis = unitAxis(values.data());
    return axis == glm::dvec3(0.0) ? glm::dquat(1.0, 0.0, 0.0, 0.0)
                                   : glm::angleAxis(glm::radians(values[3]), axis);
}

}  // namespace

StackParts::StackParts(const JointMotion& motion) {
    for (std::size_t e = 0; e < motion.stack.size(); ++e) {
        Step step{motion.stack[e].kind, {}, {}, moved_.size(), 0};
        std::copy_n(motion.stack[e].values.begin(), step.values.size(), step.values.begin());
        for (const CurveBinding& binding : motion.bindings)
            if (binding.element == e) moved_.push_back({binding});
        step.bindings = moved_.size() - step.binding;
        if (step.kind == Kind::Rotate) step.rotation = rotationOf(step.values);
        steps_.push_back(step);
    }
}

void StackParts::move(const Step& step, double seconds, Side side, std::array<double, 4>& values) {
    std::array<double, 16> numbers;
    for (std::size_t i = step.binding; i < step.binding + step.bindings; ++i) {
        const CurveBinding& b = moved_[i].binding;
        if (!isInForce(b, seconds, side)) continue;
        b.curve->evaluate(seconds, side, numbers, moved_[i].hint);
        for (std::size_t n = 0; n < b.count; ++n) values[b.first + n] = b.scale * numbers[b.component + n];
    }
}

bool StackParts::at(double seconds, Side side, MatrixParts& parts) {
    parts = {};
    glm::dvec3 scale(1.0);
    bool isRotated = false;
    for (const Step& step : steps_) {
        std::array<double, 4> values = step.values;
        if (step.bindings > 0) move(step, seconds, side, values);
        const glm::dvec3 vector(values[0], values[1], values[2]);
        if (step.kind == Kind::Translate) {
            parts.position += isRotated ? parts.rotation * vector : vector;
        } else if (step.kind == Kind::Scale) {
            scale *= vector;
        } else {
            const glm::dquat rotation = step.bindings > 0 ? rotationOf(values) : step.rotation;
            parts.rotation = isRotated ? parts.rotation * rotation : rotation;
            isRotated = true;
        }
    }
    for (int i = 0; i < 3; ++i) parts.stretch[i][i] = scale[i];
    const double most = std::max({scale.x, scale.y, scale.z});
    return std::min({scale.x, scale.y, scale.z}) > 1e-6 * most;
}

}  // namespace walkcycle
