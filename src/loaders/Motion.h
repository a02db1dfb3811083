#pragma once

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "loaders/Curve.h"
#include "loaders/SceneGraph.h"
#include "model/ExactMotion.h"

namespace walkcycle {

// One channel at one place: numbers of a curve that replace numbers of a transform element.
struct CurveBinding {
    const Curve* curve = nullptr;
    std::size_t component = 0;  // the curve's first number that is used
    std::size_t element = 0;    // of JointMotion::stack
    std::size_t first = 0;      // of the element's numbers
    std::size_t count = 1;
    double scale =
        1.0;  // of the curve's values: an <asset> on the animation may count in another unit, or backwards
    int channel = 0;  // in document order
    // Where several channels move the same numbers one after the other, each rules from its first key on.
    double from = -std::numeric_limits<double>::infinity();
};

// A joint that moves: its transform stack, and the curves bound to its numbers.
struct JointMotion {
    struct Element {
        TransformElement::Kind kind = TransformElement::Kind::Matrix;
        std::array<double, 16> values{};
    };
    int joint = 0;
    glm::dmat4 outer{1.0};
    std::vector<Element> stack;
    std::vector<CurveBinding> bindings;

    glm::dmat4 localTransform(double seconds, Side side = Side::Right) const;
    // All times within [from, to] at which the motion may change its course, in order, `from` and `to` included.
    std::vector<double> knots(double from, double to, std::size_t limit) const;
    // True if nothing moves strictly between two neighbouring knots.
    bool holds(double from, double to) const;
    // False if it certainly has no jumps.
    bool mayJump() const;
    // True if keyframes go just as it does between its knots: a whole <matrix> with LINEAR keys, and nothing else.
    bool isStraight() const;
    // The same for a plain stack: one angle turns, and nothing that it turns moves.
    // (As long as no two knots are more than half a circle apart.)
    bool turnsStraight() const;
    // True if the stack is translations and rotations with nothing behind them but scales, as in nearly all files that
    // have curves for single numbers.
    bool hasPlainStack() const;
    // The same for matrix keyframes: every number of a <matrix> on LINEAR keys of its own.
    bool isStraightByNumber() const;
    // Says which of several bindings to the same numbers rules when (see CurveBinding::from).
    void settleRivals();
    // No less than the degrees that the joint turns between each two neighbouring knots; empty where it does not turn by
    // degrees.
    std::vector<double> degreesTurned(const std::vector<double>& knots) const;

private:
    std::optional<glm::dmat4> wholeMatrix(double seconds, Side side) const;
};

// A parameter that moves.
struct ParameterMotion {
    struct Binding {
        const Curve* curve = nullptr;
        std::size_t component = 0;
        int channel = 0;
        double from = -std::numeric_limits<double>::infinity();
    };
    int parameter = 0;
    double restValue = 0.0;
    std::vector<Binding> bindings;

    double value(double seconds, Side side = Side::Right) const;
    std::vector<double> knots(double from, double to, std::size_t limit) const;
    bool holds(double from, double to) const;
    bool mayJump() const;
    void settleRivals();
};

// Whether a binding has taken over from its rivals at a time.
template <typename Binding>
bool rules(const Binding& binding, double seconds, Side side) {
    return side == Side::Right ? seconds >= binding.from : seconds > binding.from;
}

// Whether two channels move the same numbers of a joint's stack.
bool overlap(const CurveBinding& a, const CurveBinding& b);

// All curves of a document at work: what pose --exact prints, and what keyframes are made from.
class Motion : public ExactMotion {
public:
    Motion(std::vector<Curve> curves, const SceneGraph& scene);

    void evaluate(double seconds, std::span<glm::dmat4> localTransforms,
                  std::span<double> parameters) const override;

    // The same with only those channels at work that `plays` says yes to; the curves are shared.
    Motion restricted(const std::function<bool(int)>& plays) const;

    const std::vector<Curve>& curves() const { return *curves_; }
    double start() const;  // first key time of all that moves
    double end() const;
    std::vector<JointMotion> joints;  // those that move
    std::vector<ParameterMotion> parameters;
    std::vector<double> restParameters;

private:
    std::shared_ptr<const std::vector<Curve>> curves_;
    std::vector<glm::dmat4> restTransforms_;
};

}  // namespace walkcycle
