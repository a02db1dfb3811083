#pragma once

#include "walkcycle/animation/Animation.h"

namespace walkcycle {

// The track's value at a time of the document's timeline. The track must have key frames.
float sample(const ParameterTrack& track, double seconds);

}  // namespace walkcycle
