#pragma once

#include <vector>

#include "walkcycle/animation/KeyFrame.h"

namespace walkcycle {

// The transform at a time of the document's timeline. `tangents` has one entry per key frame.
JointTransform sampleCubic(const std::vector<KeyFrame>& keyFrames, const std::vector<KeyTangents>& tangents,
                           double seconds);

}  // namespace walkcycle
