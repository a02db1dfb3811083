#pragma once

#include <vector>

#include "animation/CurvedTransform.h"
#include "animation/KeyFrame.h"

namespace walkcycle {

// How fast the numbers of a transform change as they arrive at a key frame and as they leave it, per second. With
// tangents, each number runs on a cubic curve from key frame to key frame (glTF's CUBICSPLINE).
struct KeyTangents {
    using Rates = TransformRates<float>;
    Rates in, out;
};

// The transform at a time of the document's timeline. `tangents` has one entry per key frame.
JointTransform sampleCubic(const std::vector<KeyFrame>& keyFrames, const std::vector<KeyTangents>& tangents,
                           double seconds);

}  // namespace walkcycle
