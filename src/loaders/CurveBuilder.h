#pragma once

#include <cstdint>
#include <vector>

#include "loaders/Curve.h"

namespace walkcycle {

// COLLADA's names for how a curve goes from one key to the next.
enum class Interpolation : std::uint8_t { Linear, Step, Bezier, Hermite, Cardinal, BSpline };

// The numbers of a <sampler>, as they stand in the file. Entry i of each list belongs to key i; a key's
// interpolation is that of the segment which it starts.
struct CurveKeys {
    std::size_t width = 1;  // numbers per key of `values`
    std::vector<double> times, values;
    std::vector<Interpolation> interpolations;
    std::size_t tangentWidth =
        0;  // 2 * width: (seconds, value) each; width: values; width + 1: one time for all
    std::vector<double> inTangents, outTangents;  // empty: none
};

// True if tangents of this many numbers per key can be read.
bool tangentsFit(std::size_t tangentWidth, std::size_t width);

// Turns every kind of segment into what Curve evaluates. Times must not fall; each segment that needs tangents
// must have them.
Curve makeCurve(CurveKeys keys);

}  // namespace walkcycle
