#include "animation/ParameterTrack.h"

#include <cstddef>

#include "animation/Interpolation.h"
#include "animation/KeyFrameSearch.h"

namespace walkcycle {

float sample(const ParameterTrack& track, double seconds) {
    const auto [previous, next] = getPreviousAndNextFrames(track.keyFrames, seconds);
    if (&previous == &next) return previous.value;
    const float progression = calculateProgression(previous.seconds, next.seconds, seconds);
    if (track.tangents.empty()) return previous.value + (next.value - previous.value) * progression;
    const Hermite<float> curve(progression, static_cast<float>(next.seconds - previous.seconds));
    const auto left = static_cast<std::size_t>(&previous - track.keyFrames.data());
    return curve.value(previous.value, track.tangents[left].out, next.value, track.tangents[left + 1].in);
}

}  // namespace walkcycle
