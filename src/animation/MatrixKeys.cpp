#include "animation/MatrixKeys.h"

#include "animation/KeyFrameSearch.h"

namespace walkcycle {

glm::mat4 sampleMatrix(const std::vector<MatrixKeyFrame>& keyFrames, double seconds) {
    const auto [previous, next] = getPreviousAndNextFrames(keyFrames, seconds);
    if (&previous == &next) return previous.matrix;
    const float progression = calculateProgression(previous.seconds, next.seconds, seconds);
    return previous.matrix * (1.0f - progression) + next.matrix * progression;
}

}  // namespace walkcycle
