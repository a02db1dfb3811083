#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "loaders/curves/MatrixParts.h"

namespace walkcycle {
namespace {

double apart(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0.0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) most = std::max(most, std::abs(a[c][r] - b[c][r]));
    return most;
}

glm::dmat4 rotatedBy(double degrees) {
    return glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::dvec3(1, 2, 3));
}

TEST(MatrixPartsTest, partsMakeTheMatrixAgainWhateverItIs) {
    const glm::dmat4 sheared(2, 0, 0, 0, 1, 1, 0, 0, 0.5, 0, -3, 0, 7, 8, 9, 1);
    for (const glm::dmat4& m :
         {rotatedBy(40), glm::scale(rotatedBy(200), glm::dvec3(2, 3, 4)), sheared,
          glm::scale(rotatedBy(10), glm::dvec3(1, 1, -2)), glm::scale(rotatedBy(10), glm::dvec3(0, 1, 1)),
          glm::scale(rotatedBy(10), glm::dvec3(1, 0, 0)), glm::scale(rotatedBy(10), glm::dvec3(0))})
        EXPECT_LT(apart(partsOf(m).toMatrix(), m), 1e-12);
}

TEST(MatrixPartsTest, scalesComeOutWithoutShear) {
    const MatrixParts parts = partsOf(glm::scale(rotatedBy(77), glm::dvec3(2, 3, 4)));
    EXPECT_NEAR(glm::distance(parts.scale(), glm::dvec3(2, 3, 4)), 0.0, 1e-12);
    EXPECT_NEAR(parts.stretch[1][0], 0.0, 1e-12);
}

TEST(MatrixPartsTest, aMirrorIsANegativeFirstScale) {
    const MatrixParts parts = partsOf(glm::scale(rotatedBy(30), glm::dvec3(1, 1, -1)));
    EXPECT_NEAR(parts.scale().x, -1.0, 1e-12);
    EXPECT_NEAR(glm::determinant(glm::mat3_cast(parts.rotation)), 1.0, 1e-12);
}

TEST(MatrixPartsTest, whatIsFlattenedTakesTheRotationItIsGiven) {
    const glm::dquat near = glm::angleAxis(1.0, glm::dvec3(0, 0, 1));
    const MatrixParts parts = partsOf(glm::dmat4(0.0), near);
    EXPECT_FALSE(parts.hasRotation);
    EXPECT_NEAR(std::abs(glm::dot(parts.rotation, near)), 1.0, 1e-12);
    // One lost axis leaves no doubt.
    EXPECT_TRUE(partsOf(glm::scale(rotatedBy(50), glm::dvec3(1, 1, 0))).hasRotation);
}

TEST(MatrixPartsTest, blendsRotateTheShortWay) {
    const MatrixParts a = partsOf(glm::rotate(glm::dmat4(1.0), glm::radians(170.0), glm::dvec3(0, 0, 1)));
    const MatrixParts b = partsOf(glm::rotate(glm::dmat4(1.0), glm::radians(-170.0), glm::dvec3(0, 0, 1)));
    EXPECT_NEAR(blend(a, b, 0.5).toMatrix()[0].x, -1.0, 1e-12);
}

// Whatever is lost, the parts multiply to the matrix again, and the axes that are left give the rotation.
TEST(MatrixPartsTest, anyAxesMayBeLost) {
    const glm::dquat near = glm::angleAxis(1.0, glm::normalize(glm::dvec3(1, 1, 0)));
    const glm::dmat4 rotation = rotatedBy(35);
    for (const glm::dvec3& scale : {glm::dvec3(0, 1, 1), glm::dvec3(1, 0, 1), glm::dvec3(1, 1, 0),
                                    glm::dvec3(0, 0, 2), glm::dvec3(0, 2, 0), glm::dvec3(2, 0, 0)}) {
        const glm::dmat4 matrix = glm::scale(rotation, scale);
        const MatrixParts parts = partsOf(matrix, near);
        EXPECT_LT(apart(parts.toMatrix(), matrix), 1e-12) << scale.x << scale.y << scale.z;
        const bool oneLost = scale.x + scale.y + scale.z == 2.0 && scale.x < 2 && scale.y < 2 && scale.z < 2;
        EXPECT_EQ(parts.hasRotation, oneLost);
        if (oneLost) {
            EXPECT_LT(apart(glm::dmat4(glm::mat3_cast(parts.rotation)), rotation), 1e-12);
        }
    }
}

// The rotation that is given may have its axes just where the only one left is: then its others serve.
TEST(MatrixPartsTest, theOneAxisThatIsLeftMayLieAlongAnyOther) {
    const std::vector<glm::dvec3> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int column = 0; column < 3; ++column)
        for (const glm::dvec3& along : axes) {
            glm::dmat4 matrix(0.0);
            matrix[3].w = 1.0;
            matrix[column] = glm::dvec4(3.0 * along, 0.0);
            const MatrixParts parts = partsOf(matrix);
            EXPECT_FALSE(parts.hasRotation);
            EXPECT_LT(apart(parts.toMatrix(), matrix), 1e-12);
            EXPECT_NEAR(glm::length(parts.rotation), 1.0, 1e-12);
        }
}

}  // namespace
}  // namespace walkcycle
