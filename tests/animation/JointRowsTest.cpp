#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "animation/Rows.h"
#include "walkcycle/animation/JointRows.h"

namespace walkcycle {
namespace {

glm::mat4 sheared() {
    glm::mat4 matrix = glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(0.6f, 0.0f, 0.8f));
    matrix[1] += 0.5f * matrix[0];
    matrix[3] = {1.0f, -2.0f, 3.0f, 1.0f};
    return matrix;
}

void expectNear(const glm::mat4& a, const glm::mat4& b) {
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(a[i / 4][i % 4], b[i / 4][i % 4], 1e-6f) << i;
}

TEST(JointRowsTest, theMatrixComesBackAsItWas) {
    EXPECT_EQ(JointRows(sheared()).toMatrix(), sheared());
    EXPECT_EQ(JointRows().toMatrix(), glm::mat4(1.0f));
}

TEST(JointRowsTest, aPlacedPaletteIsThePlacementTimesEachJoint) {
    const glm::mat4 placement = glm::translate(sheared(), {4.0f, 5.0f, 6.0f});
    const glm::mat4 second = glm::scale(sheared(), {1.0f, 2.0f, 0.5f});
    JointRows palette[] = {JointRows(sheared()), JointRows(second)};

    place(palette, placement);

    expectNear(palette[0].toMatrix(), placement * sheared());
    expectNear(palette[1].toMatrix(), placement * second);
}

// What Float4 does with four numbers at once is what one number after the other gives.
TEST(JointRowsTest, fourRowsBecomeFourColumns) {
    Float4 a{1, 2, 3, 4}, b{5, 6, 7, 8}, c{9, 10, 11, 12}, d{13, 14, 15, 16};
    transpose(a, b, c, d);
    const Float4 rows[] = {a, b, c, d};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_EQ(rows[row][column], static_cast<float>(4 * column + row + 1));
}

}  // namespace
}  // namespace walkcycle
