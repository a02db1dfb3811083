#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "loaders/MatrixParts.h"

namespace walkcycle {

// What a curve does before its first and after its last key.
enum class Infinity : std::uint8_t { Constant, Linear, Cycle, CycleRelative, Oscillate };

// At a jump, the value just before it or from it on.
enum class Side : std::uint8_t { Left, Right };

// The values of a <sampler> over time, in double. All of COLLADA's interpolations are held as three kinds of
// segments, since HERMITE, CARDINAL and BSPLINE are Bezier curves given by other numbers (see CurveBuilder).
class Curve {
public:
    enum class Kind : std::uint8_t { Step, Linear, Bezier };
    struct Segment {
        Kind kind = Kind::Linear;
        std::size_t handles = 0;  // Bezier: where its 2 * width handles start, those of a component together
    };

    std::size_t width = 1;            // numbers per key
    std::vector<double> times;        // seconds, never falling; two equal ones are a jump
    std::vector<double> values;       // width per key
    std::vector<Segment> segments;    // one less than keys
    std::vector<glm::dvec2> handles;  // (seconds, value) of the Beziers' inner control points
    std::vector<MatrixParts> parts;   // one per key, where the values are whole matrices: LINEAR blends these
    Infinity before = Infinity::Constant, after = Infinity::Constant;

    double start() const { return times.front(); }
    double end() const { return times.back(); }

    // False if it certainly has no jumps.
    bool mayJump() const;

    // Writes `width` values. There must be a key.
    void evaluate(double seconds, Side side, std::span<double> out) const;

    // The same, for many times in order: `place` is where the last one was found (0 at first).
    void evaluate(double seconds, Side side, std::span<double> out, std::size_t& place) const;

    // Where LINEAR leads from one whole matrix to the next: the matrix between them, without a detour over its numbers.
    std::optional<glm::dmat4> blendedAt(double seconds, Side side) const;

    // True if nothing changes strictly between two times that have no knot between them.
    bool holds(double from, double to) const;
    bool holds(double from, double to, std::size_t& place) const;  // as for evaluate()

    // Times within [from, to] where a new piece of the curve begins, appended; at most `limit` of them.
    void knots(double from, double to, std::size_t limit, std::vector<double>& out) const;

    // No less than the way that a component goes between two times that have no knot between them.
    double travel(double from, double to, std::size_t component, std::size_t& place) const;

private:
    struct Place {  // a time, brought back to within the keys
        double seconds = 0.0;
        Side side = Side::Right;
        double cycles = 0.0;  // CycleRelative: how many times the curve's own rise is added
        double beyond = 0.0;  // Linear: seconds past the end
    };
    Place placeOf(double seconds, Side side) const;
    std::size_t segmentAt(double seconds, Side side) const;
    std::size_t segmentAt(double seconds, Side side, std::size_t near) const;
    void evaluateInside(double seconds, Side side, std::span<double> out, std::size_t& place) const;
    double bezier(std::size_t segment, std::size_t component, double seconds) const;
    double slope(bool atEnd, std::size_t component) const;
};

// The parameter at which a cubic Bezier's time, rising from a to d with b and c between them, is `seconds`.
double bezierParameter(double a, double b, double c, double d, double seconds);

}  // namespace walkcycle
