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
    std::size_t spareKeys = SIZE_MAX;  // beyond two per key of the file and a few
};

// Makes the key frames of one joint from its exact motion. `times` are the motion's knots between the clip's start and
// end, both included. Steps stay steps, and a jump becomes two keys at one time. Smooth motion gets cubic curves if
// straight lines would need more keys than the file has. What a joint transform cannot hold (shear, and mirroring or
// flattening on the way) becomes matrices.
Channel fitChannel(const JointMotion& motion, const std::vector<double>& times, const Tolerance& tolerance,
                   const KeyLimits& limits = {});

// The same for one number.
ParameterTrack fitTrack(const ParameterMotion& motion, const std::vector<double>& times,
                        const Tolerance& tolerance, const KeyLimits& limits = {});

}  // namespace walkcycle
