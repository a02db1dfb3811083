#include <vector>

#include <gtest/gtest.h>

#include "animation/MatrixKeys.h"

namespace walkcycle {
namespace {

glm::mat4 stretched(float x) {
    glm::mat4 matrix(1.0f);
    matrix[0].x = x;
    return matrix;
}

TEST(MatrixKeysTest, matricesBlendNumberByNumber) {
    const std::vector<MatrixKeyFrame> mirroring{{0.0, stretched(1.0f)}, {2.0, stretched(-1.0f)}};

    EXPECT_FLOAT_EQ(sampleMatrix(mirroring, 0.5)[0].x, 0.5f);
    EXPECT_FLOAT_EQ(sampleMatrix(mirroring, 1.0)[0].x, 0.0f);
    EXPECT_FLOAT_EQ(sampleMatrix(mirroring, 1.0)[1].y, 1.0f);
}

TEST(MatrixKeysTest, theFirstAndTheLastMatrixHoldOutside) {
    const std::vector<MatrixKeyFrame> keyFrames{{1.0, stretched(1.0f)}, {2.0, stretched(3.0f)}};

    EXPECT_EQ(sampleMatrix(keyFrames, 0.0)[0].x, 1.0f);
    EXPECT_EQ(sampleMatrix(keyFrames, 2.0)[0].x, 3.0f);
    EXPECT_EQ(sampleMatrix(keyFrames, 9.0)[0].x, 3.0f);
}

TEST(MatrixKeysTest, aStepHoldsUntilTheNextMatrix) {
    const std::vector<MatrixKeyFrame> keyFrames{{0.0, stretched(1.0f), true}, {1.0, stretched(3.0f)}};

    EXPECT_EQ(sampleMatrix(keyFrames, 0.999)[0].x, 1.0f);
    EXPECT_EQ(sampleMatrix(keyFrames, 1.0)[0].x, 3.0f);
}

}  // namespace
}  // namespace walkcycle
