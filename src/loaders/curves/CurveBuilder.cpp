#include "loaders/curves/CurveBuilder.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "animation/RowMajor.h"

namespace walkcycle {

namespace {

// One component of the keys, as points (seconds, value) of the plane in which COLLADA defines its splines
// (COLLADA 1.4.1, chapter 4, "Curve Interpolation").
struct Points {
    const CurveKeys& keys;
    std::size_t component;
    std::size_t first = 0, last = keys.times.size() - 1;  // the keys of the spline

    glm::dvec2 at(std::size_t i) const { return {keys.times[i], keys.values[i * keys.width + component]}; }

    // Before its first and after its last key, a spline continues with mirrored points. So it starts and ends
    // at its end keys, without curvature there.
    glm::dvec2 before(std::size_t i) const { return i > first ? at(i - 1) : 2.0 * at(i) - at(i + 1); }
    glm::dvec2 after(std::size_t i) const { return i < last ? at(i + 1) : 2.0 * at(i) - at(i - 1); }
};

// The tangent of a key as in the file: for BEZIER a control point, for HERMITE a tangent. If it has values
// but no times, the time is `evenTime`: control points are at the thirds of the segment.
glm::dvec2 tangent(const CurveKeys& keys, bool incoming, std::size_t key, std::size_t component,
                   double evenTime) {
    const double* numbers = (incoming ? keys.inTangents : keys.outTangents).data() + key * keys.tangentWidth;
    if (keys.tangentWidth == 2 * keys.width) return {numbers[2 * component], numbers[2 * component + 1]};
    if (keys.tangentWidth == keys.width + 1) return {numbers[0], numbers[1 + component]};
    return {evenTime, numbers[component]};
}

struct Handles {
    glm::dvec2 out, in;  // the inner control points of a cubic Bezier
};

Handles handlesOf(const CurveKeys& keys, std::size_t i, std::size_t component) {
    const Points points{keys, component};
    const glm::dvec2 a = points.at(i), b = points.at(i + 1);
    const double length = b.x - a.x;
    switch (keys.interpolations[i]) {
        case Interpolation::Bezier:
            return {tangent(keys, false, i, component, a.x + length / 3.0),
                    tangent(keys, true, i + 1, component, b.x - length / 3.0)};
        case Interpolation::Hermite:
            return {a + tangent(keys, false, i, component, length) / 3.0,
                    b - tangent(keys, true, i + 1, component, length) / 3.0};
        case Interpolation::Cardinal:  // without tension: Catmull-Rom
            return {a + (b - points.before(i)) / 6.0, b - (points.after(i + 1) - a) / 6.0};
        case Interpolation::
            BSpline:  // moveOntoSplines() moves the ends; handles are at the thirds between keys
        case Interpolation::Linear:
        case Interpolation::Step:
            break;
    }
    return {(2.0 * a + b) / 3.0, (a + 2.0 * b) / 3.0};
}

// A B-spline does not pass through its keys, except at both ends, where it meets the segments of other kinds.
// Moves the inner points of each B-spline from the keys onto the curve.
void moveOntoSplines(const CurveKeys& keys, Curve& curve) {
    const std::size_t segmentCount = keys.times.size() - 1;
    for (std::size_t i = 0; i < segmentCount; ++i) {
        if (keys.interpolations[i] != Interpolation::BSpline) continue;
        const std::size_t first = i;
        while (i < segmentCount && keys.interpolations[i] == Interpolation::BSpline) ++i;
        for (std::size_t k = first + 1; k < i; ++k)
            for (std::size_t c = 0; c < keys.width; ++c) {
                const Points points{keys, c, first, i};
                const glm::dvec2 p = (points.before(k) + 4.0 * points.at(k) + points.after(k)) / 6.0;
                curve.times[k] = p.x;
                curve.values[k * keys.width + c] = p.y;
            }
    }
}

// Handles outside the time of their segment would let time run backwards. They are clamped to its ends.
void addHandles(const CurveKeys& keys, std::size_t i, Curve& curve) {
    for (std::size_t c = 0; c < keys.width; ++c) {
        Handles h = handlesOf(keys, i, c);
        h.out.x = std::clamp(h.out.x, curve.times[i], curve.times[i + 1]);
        h.in.x = std::clamp(h.in.x, curve.times[i], curve.times[i + 1]);
        curve.handles.push_back(h.out);
        curve.handles.push_back(h.in);
    }
}

bool isPlain(Interpolation interpolation) {
    return interpolation == Interpolation::Linear || interpolation == Interpolation::Step;
}

// Decomposes the matrices of the keys. A key without a rotation, because it scales to nothing, takes that of
// the key before it, or else of the first key that has one.
void splitMatrices(Curve& curve) {
    curve.parts.reserve(curve.times.size());
    glm::dquat near{1.0, 0.0, 0.0, 0.0};
    for (std::size_t pass = 0; pass < 2; ++pass) {
        curve.parts.clear();
        glm::dquat previous = near;
        bool found = false;
        for (std::size_t i = 0; i < curve.times.size(); ++i) {
            curve.parts.push_back(partsOf(affineFromRows<double>(&curve.values[i * 16]), previous));
            previous = curve.parts.back().rotation;
            if (curve.parts.back().hasRotation && !found) near = previous, found = true;
        }
        if (curve.parts.front().hasRotation || !found) break;
    }
}

}  // namespace

bool tangentsFit(std::size_t tangentWidth, std::size_t width) {
    return tangentWidth == 2 * width || tangentWidth == width || tangentWidth == width + 1;
}

Curve makeCurve(CurveKeys keys) {
    assert(!keys.times.empty() && keys.values.size() == keys.times.size() * keys.width);
    Curve curve;
    curve.width = keys.width;
    if (std::all_of(keys.interpolations.begin(), keys.interpolations.end(), isPlain)) {
        curve.times = std::move(keys.times);
        curve.values = std::move(keys.values);
    } else {  // the handles are made from the keys, which moveOntoSplines() moves
        curve.times = keys.times;
        curve.values = keys.values;
        moveOntoSplines(keys, curve);
    }
    curve.segments.resize(curve.times.size() - 1);
    for (std::size_t i = 0; i < curve.segments.size(); ++i) {
        const Interpolation interpolation = keys.interpolations[i];
        if (interpolation == Interpolation::Linear) continue;
        if (interpolation == Interpolation::Step) {
            curve.segments[i].kind = Curve::Kind::Step;
        } else {
            curve.segments[i] = {Curve::Kind::Bezier, curve.handles.size()};
            addHandles(keys, i, curve);
        }
    }
    if (keys.width == 16) splitMatrices(curve);
    return curve;
}

}  // namespace walkcycle
