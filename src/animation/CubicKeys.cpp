#include "animation/CubicKeys.h"

#include <cassert>
#include <cstddef>

#include "animation/CurvedTransform.h"
#include "animation/KeyFrameSearch.h"

namespace walkcycle {

// Between two key frames, each number follows the cubic Hermite curve that starts with the `out` tangent of the previous
// one and ends with the `in` tangent of the next.
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
