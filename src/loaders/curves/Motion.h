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

// A <channel> that is bound to a transform element: numbers of its curve replace numbers of the element.
struct CurveBinding {
    const Curve* curve = nullptr;
    std::size_t component = 0;  // the curve's first number that is used
    std::size_t element = 0;    // of JointMotion::stack
    std::size_t first = 0;      // of the element's numbers
    std::size_t count = 1;
    double scale =
        1.0;  // of the curve's values, where an <asset> of the animation has another unit or the opposite direction
    int channel = 0;  // in document order
    // Where several channels move the same numbers one after the other, each is in force from its first key on.
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
    // The times within [from, to] at which a segment of a curve begins, in order, with `from` and `to`.
    std::vector<double> knots(double from, double to, std::size_t limit) const;
    // True if nothing moves between two neighbouring knots.
    bool holds(double from, double to) const;
    // False if the motion certainly has no jumps.
    bool mayJump() const;
    // True if key frames at the knots reproduce the motion: a whole <matrix> with LINEAR keys, and nothing else.
    bool isStraight() const;
    // The same for matrix key frames: LINEAR curves for single numbers of a <matrix>.
    bool isStraightByNumber() const;
    // The same for transform key frames and a plain stack: only one angle is animated, and all translations after it are
    // zero. Two knots must not be more than half a circle apart.
    bool rotatesEvenly() const;
    // True if the stack is translations and rotations, then scales, as in nearly all files with curves for single
    // numbers.
    bool hasPlainStack() const;
    // Sets CurveBinding::from of the bindings that move the same numbers.
    void orderRivals();
    // An upper bound of how far the joint rotates between each two neighbouring knots, in degrees. Empty if no angle is
    // animated.
    std::vector<double> degreesRotated(const std::vector<double>& knots) const;

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
    void orderRivals();
};

// Whether a binding has taken over from the others that move the same numbers.
template <typename Binding>
bool isInForce(const Binding& binding, double seconds, Side side) {
    return side == Side::Right ? seconds >= binding.from : seconds > binding.from;
}

// Whether two channels move the same numbers of a joint's stack.
bool overlap(const CurveBinding& a, const CurveBinding& b);

// Everything that a document animates, exactly: pose --exact prints it, and key frames are made from it.
class Motion : public ExactMotion {
public:
    Motion(std::vector<Curve> curves, const SceneGraph& scene);

    void evaluate(double seconds, std::span<glm::dmat4> localTransforms,
                  std::span<double> parameters) const override;

    // A copy that has only the channels for which `plays` returns true. It shares the curves.
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
