#include <cstdint>
#include <set>

#include <gtest/gtest.h>

#include "render/SampleAverage.h"

namespace walkcycle {
namespace {

Image onePixel(std::uint8_t red, std::uint8_t alpha) {
    return {1, 1, true, {red, 0, 0, alpha}};
}

TEST(SampleAverageTest, coverageIsTheMeanOfThePasses) {
    SampleAverage average(4);
    for (const int alpha : {255, 0, 0, 0})
        average.add(onePixel(static_cast<std::uint8_t>(alpha ? 200 : 0), static_cast<std::uint8_t>(alpha)));

    EXPECT_EQ(average.image().rgba[3], 64);
    EXPECT_EQ(average.image().rgba[0], 200);  // straight: what shines through does not darken it
}

TEST(SampleAverageTest, passesStandAtEvenDistances) {
    const SampleAverage average(4);
    std::set<float> across, up;
    for (int pass = 0; pass < 4; ++pass) {
        across.insert(average.offset(pass).x);
        up.insert(average.offset(pass).y);
    }

    EXPECT_EQ(across, (std::set<float>{-0.09375f, -0.03125f, 0.03125f, 0.09375f}));
    EXPECT_EQ(up, across);
}

}  // namespace
}  // namespace walkcycle
