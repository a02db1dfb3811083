#pragma once

#include <glm/mat4x4.hpp>

#include "animation/CurvedTransform.h"
#include "animation/Interpolation.h"
#include "loaders/curves/MatrixParts.h"

namespace walkcycle {

// How far a local transform may be off. The error is measured at the farthest point that the joint moves.
struct Tolerance {
    double budget = 0.0;  // the largest allowed distance in model space
    double unit = 1.0;    // length in model space of one unit of the parent joint
    double reach = 1.0;   // from the joint to the farthest point that it moves, in the joint's own units
};

// The forms of interpolation between two keys that playback has. through() fits one to the exact motion
// between two times; at() gives its value at a progression from 0 to 1.

// Linear keys: positions and scales are interpolated linearly, rotations by slerp.
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

// The tangents of the cubic through four evenly spaced values, at the first and at the last value, per whole
// of the progression.
template <typename Value>
Value leavingTangent(const Value& first, const Value& second, const Value& third, const Value& last) {
    return first * -5.5 + second * 9.0 - third * 4.5 + last;
}
template <typename Value>
Value arrivingTangent(const Value& first, const Value& second, const Value& third, const Value& last) {
    return second * 4.5 - first - third * 9.0 + last * 5.5;
}

// Cubic keys: each number is on a cubic curve (see curvedTransform).
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

// Matrix keys, for motion that no joint transform can represent: each number of a matrix is interpolated
// linearly.
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

// Linear keys of a parameter.
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

// Cubic keys of a parameter.
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

// An upper bound of the distance in model space between the places where two transforms put the farthest
// point.
double distance(const ExactTransform& exact, const ExactTransform& keyed, const Tolerance& tolerance);
double distance(const glm::dmat4& exact, const glm::dmat4& keyed, const Tolerance& tolerance);
double distance(double exact, double keyed, const Tolerance& tolerance);

// An upper bound of the distance in model space by which the shear of a matrix moves the farthest point.
double shear(const MatrixParts& exact, const Tolerance& tolerance);

}  // namespace walkcycle
