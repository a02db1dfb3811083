#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "loaders/curves/Motion.h"
#include "loaders/keys/KeyForms.h"
#include "walkcycle/animation/Animation.h"

namespace walkcycle {

// How many key frames a motion may get.
struct KeyLimits {
    std::size_t most = SIZE_MAX;
    std::size_t spareKeys = SIZE_MAX;  // how many the fit may add beyond two per key of the file and a few
};

// Fits the key frames of one joint to its exact motion. `times` are the knots of the motion between the start
// and the end of the clip, both included. A step stays a step, and a jump becomes two keys at one time.
// Smooth motion gets cubic keys if linear ones would be more than the file has. Motion that a joint transform
// cannot represent (shear, and mirroring or flattening on the way) gets matrix keys.
Channel fitChannel(const JointMotion& motion, const std::vector<double>& times, const Tolerance& tolerance,
                   const KeyLimits& limits = {});

// The same for one parameter.
ParameterTrack fitTrack(const ParameterMotion& motion, const std::vector<double>& times,
                        const Tolerance& tolerance, const KeyLimits& limits = {});

}  // namespace walkcycle
