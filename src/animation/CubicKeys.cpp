#include "animation/CubicKeys.h"

#include <cassert>
#include <cstddef>

#include "animation/CurvedTransform.h"
#include "animation/KeyFrameSearch.h"

namespace walkcycle {

// Between two key frames, each number runs on the cubic curve that leaves the one with its `out` tangent and arrives
// at the next with the `in` tangent of that.
JointTransform sampleCubic(const std::vector<KeyFrame>& keyFrames, const std::vector<KeyTangents>& tangents,
                           double seconds) {
    assert(tangents.size() == keyFrames.size());
    const auto [previous, next] = getPreviousAndNextFrames(keyFrames, seconds);
    if (&previous == &next) return previous.transform;
    const float progression = calculateProgression(previous.seconds, next.seconds, seconds);
    const Hermite<float> curve(progression, static_cast<float>(next.seconds - previous.seconds));
    const auto left = static_cast<std::size_t>(&previous - keyFrames.data());
    return curvedTransform(previous.transform, tangents[left].out, next.transform, tangents[left + 1].in,
                           curve);
}

}  // namespace walkcycle
