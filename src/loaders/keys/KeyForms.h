#pragma once

#include <glm/mat4x4.hpp>

#include "animation/CurvedTransform.h"
#include "animation/Interpolation.h"
#include "loaders/curves/MatrixParts.h"

namespace walkcycle {

// How far off a joint's local transform may be. An error is measured where the farthest point is that the joint moves.
struct Tolerance {
    double budget = 0.0;  // model-space distance
    double unit = 1.0;    // model-space length of one unit of the joint's parent
    double reach =
        1.0;  // distance from the joint to the farthest point that it moves, in the joint's own units
};

// The forms of interpolation that the run-time has between two keys. through() fits one to the exact motion from one time
// to another, and at() gives its value at a progression from 0 to 1.

// Positions and scales on straight lines, rotations the short way round at constant speed.
struct StraightTransform {
    static constexpr bool kHasTangents = false;
    using Value = ExactTransform;
    ExactTransform a, b;
    Slerp<double> rotation;

    template <typename Exact>
    static StraightTransform through(const Exact&, double, double, const ExactTransform& a,
                                     const ExactTransform& b) {
        return {a, b, Slerp(a.rotation, b.rotation)};
    }
    ExactTransform at(double progression) const;
};

// Of the one cubic through four evenly spaced values: its tangents at the first and at the last, per way between them.
template <typename Value>
Value leavingTangent(const Value& first, const Value& second, const Value& third, const Value& last) {
    return first * -5.5 + second * 9.0 - third * 4.5 + last;
}
template <typename Value>
Value arrivingTangent(const Value& first, const Value& second, const Value& third, const Value& last) {
    return second * 4.5 - first - third * 9.0 + last * 5.5;
}

// Each number on a cubic curve (see curvedTransform).
struct CurvedTransform {
    static constexpr bool kHasTangents = true;
    using Value = ExactTransform;
    ExactTransform a, b;
    TransformRates<double> leaving, arriving;  // tangents at the ends, per whole of the progression

    template <typename Exact>
    static CurvedTransform through(const Exact& exact, double from, double to, const ExactTransform& a,
                                   const ExactTransform& b) {
        const double third = (to - from) / 3.0;
        return throughFour(a, exact(from + third), exact(to - third), b);
    }
    static CurvedTransform throughFour(const ExactTransform& a, const ExactTransform& third,
                                       const ExactTransform& twoThirds, const ExactTransform& b);
    const ExactTransform& end() const { return b; }
    ExactTransform at(double progression) const;
};

// For motion that no joint transform can hold: each number of a matrix on a straight line.
struct StraightMatrix {
    static constexpr bool kHasTangents = false;
    using Value = glm::dmat4;
    glm::dmat4 a{1.0}, b{1.0};

    template <typename Exact>
    static StraightMatrix through(const Exact&, double, double, const glm::dmat4& a, const glm::dmat4& b) {
        return {a, b};
    }
    glm::dmat4 at(double progression) const { return a * (1.0 - progression) + b * progression; }
};

struct StraightNumber {
    static constexpr bool kHasTangents = false;
    using Value = double;
    double a = 0.0, b = 0.0;

    template <typename Exact>
    static StraightNumber through(const Exact&, double, double, double a, double b) {
        return {a, b};
    }
    double at(double progression) const { return a + (b - a) * progression; }
};

struct CurvedNumber {
    static constexpr bool kHasTangents = true;
    using Value = double;
    double a = 0.0, b = 0.0;
    double leaving = 0.0, arriving = 0.0;  // tangents at the ends, per whole of the progression

    template <typename Exact>
    static CurvedNumber through(const Exact& exact, double from, double to, double a, double b) {
        const double third = (to - from) / 3.0;
        const double c = exact(from + third), d = exact(to - third);
        return {a, b, leavingTangent(a, c, d, b), arrivingTangent(a, c, d, b)};
    }
    double end() const { return b; }
    double at(double progression) const { return Hermite(progression).value(a, leaving, b, arriving); }
};

// Upper bound of the distance in model space between where two transforms put the farthest point.
double distance(const ExactTransform& exact, const ExactTransform& keyed, const Tolerance& tolerance);
double distance(const glm::dmat4& exact, const glm::dmat4& keyed, const Tolerance& tolerance);
double distance(double exact, double keyed, const Tolerance& tolerance);

// How far shear moves the farthest point.
double shear(const MatrixParts& exact, const Tolerance& tolerance);

}  // namespace walkcycle
