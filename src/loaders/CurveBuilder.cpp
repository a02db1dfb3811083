#include "loaders/CurveBuilder.h"

#include <algorithm>
#include <cassert>

namespace walkcycle {

namespace {

// One component of the keys, as points of the plane (seconds, value), where all of COLLADA's splines live
// (COLLADA 1.4.1, chapter 4, "Curve Interpolation").
struct Points {
    const CurveKeys& keys;
    std::size_t component;
    std::size_t first = 0, last = keys.times.size() - 1;  // the run of keys that a spline knows about

    glm::dvec2 at(std::size_t i) const { return {keys.times[i], keys.values[i * keys.width + component]}; }

    // Beyond its ends a spline has mirrored points, so that it starts and ends straight, and at its end keys.
    glm::dvec2 before(std::size_t i) const { return i > first ? at(i - 1) : 2.0 * at(i) - at(i + 1); }
    glm::dvec2 after(std::size_t i) const { return i < last ? at(i + 1) : 2.0 * at(i) - at(i - 1); }
};

// What the file gives for a key: for BEZIER a control point, for HERMITE a tangent. Tangents of one number have
// no time of their own: it runs evenly, control points then stand at the thirds.
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
        case Interpolation::Cardinal:  // of no tension: Catmull-Rom
            return {a + (b - points.before(i)) / 6.0, b - (points.after(i + 1) - a) / 6.0};
        case Interpolation::BSpline:  // its end points have been moved onto the curve already
        case Interpolation::Linear:
        case Interpolation::Step:  // the last two are no Beziers: nobody asks for their handles
            break;
    }
    return {(2.0 * a + b) / 3.0, (a + 2.0 * b) / 3.0};  // at the thirds between the keys
}

// A B-spline passes its keys by; where a run of its segments begins and ends it goes through the key, so that it joins
// what comes before and after. Moves the inner points of every run onto the curve.
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

// Handles that leave their segment's time would make the curve turn back; they are stopped at its ends.
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

glm::dmat4 matrixFromRows(const double* v) {
    return {v[0], v[4], v[8], 0.0, v[1], v[5], v[9], 0.0, v[2], v[6], v[10], 0.0, v[3], v[7], v[11], 1.0};
}

// Keys that are flattened to nothing do not turn: they take the rotation of the key before them, or of the first
// one that has a rotation.
void splitMatrices(Curve& curve) {
    curve.parts.reserve(curve.times.size());
    glm::dquat near{1.0, 0.0, 0.0, 0.0};
    for (std::size_t pass = 0; pass < 2; ++pass) {
        curve.parts.clear();
        glm::dquat previous = near;
        bool found = false;
        for (std::size_t i = 0; i < curve.times.size(); ++i) {
            curve.parts.push_back(partsOf(matrixFromRows(&curve.values[i * 16]), previous));
            previous = curve.parts.back().rotation;
            if (curve.parts.back().turns && !found) near = previous, found = true;
        }
        if (curve.parts.front().turns || !found) break;
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
    } else {  // the handles are made from what the splines may move
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
