#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "loaders/curves/MatrixParts.h"

namespace walkcycle {

// What a curve does before its first and after its last key.
enum class Infinity : std::uint8_t { Constant, Linear, Cycle, CycleRelative, Oscillate };

// Which value to take at a jump: the one just before it, or the one from it on.
enum class Side : std::uint8_t { Left, Right };

// The values of a <sampler> over time, in double. Three kinds of segments are enough for all interpolations of COLLADA,
// since HERMITE, CARDINAL and BSPLINE are Bezier curves given by other numbers (see CurveBuilder).
class Curve {
public:
    enum class Kind : std::uint8_t { Step, Linear, Bezier };
    struct Segment {
        Kind kind = Kind::Linear;
        std::size_t handles = 0;  // Bezier: index of the first of its 2 * width handles, two per component
    };

    std::size_t width = 1;            // numbers per key
    std::vector<double> times;        // seconds, in order; two equal ones are a jump
    std::vector<double> values;       // width per key
    std::vector<Segment> segments;    // one fewer than keys
    std::vector<glm::dvec2> handles;  // (seconds, value) of the Beziers' inner control points
    std::vector<MatrixParts> parts;   // one per key if the values are whole matrices; LINEAR blends these
    Infinity before = Infinity::Constant, after = Infinity::Constant;

    double start() const { return times.front(); }
    double end() const { return times.back(); }

    // False if the curve certainly has no jumps.
    bool mayJump() const;

    // Writes `width` values. The curve must have a key.
    void evaluate(double seconds, Side side, std::span<double> out) const;

    // The same, faster for many times in order: `hint` is the segment of the time before (0 at first).
    void evaluate(double seconds, Side side, std::span<double> out, std::size_t& hint) const;

    // The matrix between two LINEAR keys that are whole matrices, without writing out its numbers. Nothing elsewhere.
    std::optional<glm::dmat4> blendedAt(double seconds, Side side) const;

    // True if no value changes between two times. There must be no knot between them.
    bool holds(double from, double to) const;
    bool holds(double from, double to, std::size_t& hint) const;  // as in evaluate()

    // Appends the times within [from, to] at which a new segment begins, at most `limit` of them.
    void knots(double from, double to, std::size_t limit, std::vector<double>& out) const;

    // An upper bound of how far a component moves between two times, back and forth counted both. There must be no knot
    // between them.
    double travel(double from, double to, std::size_t component, std::size_t& hint) const;

private:
    // Any time, mapped to a time between the first and the last key.
    struct KeyTime {
        double seconds = 0.0;
        Side side = Side::Right;
        double cycles =
            0.0;  // CycleRelative: how often to add the difference between the last and the first key
        double beyond = 0.0;  // Linear: seconds after the last key, or (negative) before the first
    };
    KeyTime keyTimeOf(double seconds, Side side) const;
    std::size_t segmentAt(double seconds, Side side) const;
    std::size_t segmentAt(double seconds, Side side, std::size_t near) const;
    void evaluateInside(double seconds, Side side, std::span<double> out, std::size_t& hint) const;
    double bezier(std::size_t segment, std::size_t component, double seconds) const;
    double slope(bool atEnd, std::size_t component) const;
};

// The parameter at which a cubic Bezier curve reaches the time `seconds`. a, b, c and d are the times of its control
// points, in order.
double bezierParameter(double a, double b, double c, double d, double seconds);

}  // namespace walkcycle
