#include <cstddef>

#include <gtest/gtest.h>

#include "animation/RowMajor.h"

namespace walkcycle {
namespace {

constexpr double kWritten[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1};

TEST(RowMajorTest, theFourthNumberOfARowIsTheTranslation) {
    const auto matrix = affineFromRows<float>(kWritten);

    EXPECT_EQ(matrix[3], glm::vec4(4.0f, 8.0f, 12.0f, 1.0f));
    EXPECT_EQ(matrix[0], glm::vec4(1.0f, 5.0f, 9.0f, 0.0f));
    EXPECT_EQ(rowOf(matrix, 1), glm::vec4(5.0f, 6.0f, 7.0f, 8.0f));
}

TEST(RowMajorTest, whatIsReadIsWrittenAgain) {
    const auto rows = rowsOf(affineFromRows<double>(kWritten));
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i], kWritten[i]) << i;
}

TEST(RowMajorTest, theLastRowOfAFileIsNotRead) {
    double noise[16];
    for (double& number : noise) number = 7.0;
    EXPECT_EQ(rowOf(affineFromRows<double>(noise), 3), glm::dvec4(0.0, 0.0, 0.0, 1.0));
}

}  // namespace
}  // namespace walkcycle
