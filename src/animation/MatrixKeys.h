#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

namespace walkcycle {

// A key frame for what no JointTransform can hold: animated shear, mirroring, zero scale.
struct MatrixKeyFrame {
    double seconds = 0.0;
    glm::mat4 matrix{1.0f};
    bool step = false;  // holds until the next key frame
};

// The matrix at a time of the document's timeline: between two key frames, number by number on straight lines.
glm::mat4 sampleMatrix(const std::vector<MatrixKeyFrame>& keyFrames, double seconds);

}  // namespace walkcycle
