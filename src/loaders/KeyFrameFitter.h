#pragma once

#include <cstdint>

#include "animation/Animation.h"
#include "loaders/KeyForms.h"
#include "loaders/Motion.h"

namespace walkcycle {

// Turns exact motion into the run-time's keyframes. `times`: its knots between two times of the timeline, these included.
// `limit`: no more keys than that; `spare`: nor than so many beyond two for each key of the file.
// Steps stay steps, jumps become two keys at one time. Smooth motion gets cubic curves where straight lines would need
// more keys than the file has; what no joint transform can hold (shear, mirroring or flattening on the way) gets matrices.
Channel fitChannel(const JointMotion& motion, const std::vector<double>& times, const Tolerance& tolerance,
                   std::size_t limit, std::size_t spare = SIZE_MAX);
ParameterTrack fitTrack(const ParameterMotion& motion, const std::vector<double>& knots,
                        const Tolerance& tolerance, std::size_t limit, std::size_t spare = SIZE_MAX);

}  // namespace walkcycle
