#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "loaders/curves/Curve.h"

namespace walkcycle {

// COLLADA's names for how a curve goes from one key to the next.
enum class Interpolation : std::uint8_t { Linear, Step, Bezier, Hermite, Cardinal, BSpline };

// The numbers of a <sampler> as in the file. Entry i of each list belongs to key i. A key's interpolation is
// that of the segment that starts at it.
struct CurveKeys {
    std::size_t width = 1;  // numbers per key of `values`
    std::vector<double> times, values;
    std::vector<Interpolation> interpolations;
    // Numbers per tangent. 2 * width: pairs of seconds and value; width: values; width + 1: one time, then
    // values.
    std::size_t tangentWidth = 0;
    std::vector<double> inTangents, outTangents;  // empty if there are none
};

// True if tangents of `tangentWidth` numbers per key can be read for keys of `width` numbers.
bool tangentsFit(std::size_t tangentWidth, std::size_t width);

// Makes a Curve of keys with any of COLLADA's interpolations. The times must be in order, and each segment
// that needs tangents must have them.
Curve makeCurve(CurveKeys keys);

}  // namespace walkcycle
