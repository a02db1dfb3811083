#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "loaders/curves/MatrixParts.h"

namespace walkcycle {

// How a curve continues before its first and after its last key. Constant: it holds the value. Linear: it
// continues with its slope. Cycle: it repeats. CycleRelative: it repeats, each time starting from the last
// value. Oscillate: it repeats forwards and backwards.
enum class Infinity : std::uint8_t { Constant, Linear, Cycle, CycleRelative, Oscillate };

// The side of a jump: Left is the value just before it, Right the value from it on.
enum class Side : std::uint8_t { Left, Right };

// The values of a <sampler> over time, in double precision. Three kinds of segments are enough for all
// interpolations of COLLADA, because HERMITE, CARDINAL and BSPLINE are converted to Bezier curves (see
// CurveBuilder).
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
    std::vector<MatrixParts> parts;   // one per key if the values are matrices; Linear segments blend them
    Infinity before = Infinity::Constant, after = Infinity::Constant;

    double start() const { return times.front(); }
    double end() const { return times.back(); }

    // False if the curve certainly has no jumps.
    bool mayJump() const;

    // Writes `width` values. The curve must have a key.
    void evaluate(double seconds, Side side, std::span<double> out) const;

    // The same, faster for many times in order: `hint` is the segment of the time before (0 at first).
    void evaluate(double seconds, Side side, std::span<double> out, std::size_t& hint) const;

    // The matrix at a time between two keys of a Linear segment whose values are matrices, without the detour
    // over 16 numbers. Nothing at other times.
    std::optional<glm::dmat4> blendedAt(double seconds, Side side) const;

    // True if no value changes between two times. There must be no knot between them.
    bool holds(double from, double to) const;
    bool holds(double from, double to, std::size_t& hint) const;  // as in evaluate()

    // Appends the times within [from, to] at which a segment begins, at most `limit` of them. These are the
    // knots.
    void knots(double from, double to, std::size_t limit, std::vector<double>& out) const;

    // An upper bound of the distance that a component travels between two times, back and forth added up.
    // There must be no knot between them. `hint` as in evaluate().
    double travel(double from, double to, std::size_t component, std::size_t& hint) const;

private:
    // A time that is mapped into the range of the keys.
    struct KeyTime {
        double seconds = 0.0;
        Side side = Side::Right;
        double cycles =
            0.0;  // CycleRelative: how often to add the difference of the last and the first value
        double beyond = 0.0;  // Linear: seconds after the last key, or (negative) before the first
    };
    KeyTime keyTimeOf(double seconds, Side side) const;
    std::size_t segmentAt(double seconds, Side side) const;
    std::size_t segmentAt(double seconds, Side side, std::size_t near) const;
    void evaluateInside(double seconds, Side side, std::span<double> out, std::size_t& hint) const;
    double bezier(std::size_t segment, std::size_t component, double seconds) const;
    double slope(bool atEnd, std::size_t component) const;
};

// The parameter at which a cubic Bezier curve reaches the time `seconds`. a, b, c and d are the times of its
// control points, in order.
double bezierParameter(double a, double b, double c, double d, double seconds);

}  // namespace walkcycle
