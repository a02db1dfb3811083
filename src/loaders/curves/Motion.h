#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "loaders/curves/Curve.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/ExactMotion.h"

namespace walkcycle {

// A <channel> that is bound to a transform element of a joint: numbers of its curve replace `count` numbers
// of the element.
struct CurveBinding {
    const Curve* curve = nullptr;
    std::size_t component = 0;  // the first number of the curve that is used
    std::size_t element = 0;    // index into JointMotion::stack
    std::size_t first = 0;      // the first number of the element that is replaced
    std::size_t count = 1;
    // Factor of the values of the curve: not 1 if the <asset> of the <animation> has another unit or other
    // axes.
    double scale = 1.0;
    int channel = 0;  // index in document order
    // If several channels move the same numbers one after the other, each is in force from its first key on.
    double from = -std::numeric_limits<double>::infinity();
};

// The motion of a joint: its transform stack, and the curves bound to numbers of the stack.
struct JointMotion {
    struct Element {
        TransformElement::Kind kind = TransformElement::Kind::Matrix;
        std::array<double, 16> values{};
    };
    int joint = 0;
    glm::dmat4 outer{1.0};  // left of the stack: see SceneGraph::outer
    std::vector<Element> stack;
    std::vector<CurveBinding> bindings;

    // Relative to the parent joint.
    glm::dmat4 localTransform(double seconds, Side side = Side::Right) const;
    // The times within [from, to] at which a segment of a curve begins, in order, with `from` and `to`.
    std::vector<double> knots(double from, double to, std::size_t limit) const;
    // True if nothing moves between two neighbouring knots.
    bool holds(double from, double to) const;
    // False if the motion certainly has no jumps.
    bool mayJump() const;
    // True if transform key frames at the knots reproduce the motion: the stack is one <matrix>, moved as a
    // whole by LINEAR keys.
    bool isStraight() const;
    // True if matrix key frames at the knots reproduce the motion: the stack is one <matrix>, whose numbers
    // are moved one by one by LINEAR keys.
    bool isStraightByNumber() const;
    // True if transform key frames at the knots reproduce the motion of a plain stack: all curves are LINEAR,
    // one of them at most moves an angle, and all translations after that angle are zero. Two neighbouring
    // knots must not be more than half a circle apart.
    bool rotatesEvenly() const;
    // True if the stack consists of translations and rotations, followed by scales, as in nearly all files
    // with curves for single numbers.
    bool hasPlainStack() const;
    // Sets CurveBinding::from of bindings that move the same numbers.
    void orderRivals();
    // Per two neighbouring knots an upper bound of the angle by which the joint rotates, in degrees. Empty if
    // no angle is animated.
    std::vector<double> degreesRotated(const std::vector<double>& knots) const;

private:
    std::optional<glm::dmat4> wholeMatrix(double seconds, Side side) const;
};

// The motion of a parameter. The functions are as in JointMotion.
struct ParameterMotion {
    struct Binding {
        const Curve* curve = nullptr;
        std::size_t component = 0;
        int channel = 0;
        double from = -std::numeric_limits<double>::infinity();
    };
    int parameter = 0;  // index into Model::parameters
    double restValue = 0.0;
    std::vector<Binding> bindings;

    double value(double seconds, Side side = Side::Right) const;
    std::vector<double> knots(double from, double to, std::size_t limit) const;
    bool holds(double from, double to) const;
    bool mayJump() const;
    void orderRivals();
};

// Whether a binding has taken over from the others that move the same numbers.
template <typename Binding>
bool isInForce(const Binding& binding, double seconds, Side side) {
    return side == Side::Right ? seconds >= binding.from : seconds > binding.from;
}

// Whether two channels move the same numbers of a joint's stack.
bool overlap(const CurveBinding& a, const CurveBinding& b);

// The exact motion of a document: `pose --exact` prints it, and key frames are fitted to it.
class Motion : public ExactMotion {
public:
    Motion(std::vector<Curve> curves, const SceneGraph& scene);

    void evaluate(double seconds, std::span<glm::dmat4> localTransforms,
                  std::span<double> parameters) const override;

    // A copy that has only the channels for which `plays` returns true. It shares the curves.
    Motion restricted(const std::function<bool(int)>& plays) const;

    const std::vector<Curve>& curves() const { return *curves_; }
    double start() const;             // the first key time of all curves, in seconds
    double end() const;               // the last key time
    std::vector<JointMotion> joints;  // sorted by joint; only joints that move
    std::vector<ParameterMotion> parameters;
    std::vector<double> restParameters;

private:
    std::shared_ptr<const std::vector<Curve>> curves_;
    std::vector<glm::dmat4> restTransforms_;
};

}  // namespace walkcycle
