#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "walkcycle/animation/KeyFrame.h"

namespace walkcycle {

// The matrix at a time of the document's timeline. Between two key frames, each number is blended linearly.
glm::mat4 sampleMatrix(const std::vector<MatrixKeyFrame>& keyFrames, double seconds);

}  // namespace walkcycle
