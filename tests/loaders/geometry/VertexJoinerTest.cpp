#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "loaders/geometry/VertexJoiner.h"

namespace walkcycle {
namespace {

TEST(VertexJoinerTest, equalCornersAreOneVertex) {
    VertexJoiner joiner(2, 3, 3);
    const std::array<float, 2> a{1.0f, 2.0f}, b{1.0f, 3.0f};

    EXPECT_EQ(joiner.add(7, a.data()), 0u);
    EXPECT_EQ(joiner.add(7, b.data()), 1u);
    EXPECT_EQ(joiner.add(8, a.data()), 2u);
    EXPECT_EQ(joiner.add(7, a.data()), 0u);
    EXPECT_EQ(joiner.vertexCount(), 3u);
    EXPECT_EQ(joiner.attributes(1)[1], 3.0f);
}

TEST(VertexJoinerTest, zeroAndMinusZeroAreEqual) {
    VertexJoiner joiner(1, 2, 2);
    const float zero = 0.0f, minusZero = -0.0f;

    EXPECT_EQ(joiner.add(0, &zero), joiner.add(0, &minusZero));
}

TEST(VertexJoinerTest, itGrowsBeyondWhatWasExpected) {
    VertexJoiner joiner(1, 0, 0);
    for (int round = 0; round < 2; ++round)
        for (std::uint32_t i = 0; i < 100'000; ++i) {
            const float value = static_cast<float>(i % 10);
            ASSERT_EQ(joiner.add(i / 10, &value), i);
        }
    EXPECT_EQ(joiner.takePositions().size(), 100'000u);
}

TEST(VertexJoinerTest, manyVerticesAtOnePositionDoNotHang) {
    VertexJoiner joiner(1, 0, 0);
    for (std::uint32_t i = 0; i < 1'000'000; ++i) {
        const float value = static_cast<float>(i);
        ASSERT_EQ(joiner.add(0, &value), i);
    }
}

}  // namespace
}  // namespace walkcycle
