#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "loaders/curves/CurveBuilder.h"

namespace walkcycle {
namespace {

using I = Interpolation;

TEST(CurveBuilderTest, wholeMatricesTurnTheShortWayAtConstantSpeed) {
    CurveKeys keys{.width = 16,
                   .times = {0, 1},
                   .values = {1, 0,  0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,  //
                              0, -2, 0, 4, 2, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1},
                   .interpolations = {I::Linear, I::Linear},
                   .tangentWidth = 0,
                   .inTangents = {},
                   .outTangents = {}};
    const Curve curve = makeCurve(keys);
    std::vector<double> out(16);
    curve.evaluate(1.0 / 3.0, Side::Right, out);  // 30 degrees about z, scaled by 4/3
    EXPECT_NEAR(out[0], std::sqrt(0.75) * 4 / 3, 1e-12);
    EXPECT_NEAR(out[4], 0.5 * 4 / 3, 1e-12);
    EXPECT_NEAR(out[3], 4.0 / 3, 1e-12);
    EXPECT_DOUBLE_EQ(out[15], 1.0);
}

// A matrix that is flat says nothing about how it is turned.
TEST(CurveBuilderTest, matricesThatBeginFlatTakeTheirRotationFromTheFirstThatHasOne) {
    CurveKeys keys{.width = 16,
                   .times = {0, 1},
                   .values = {0, 0,  0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1,  //
                              0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                   .interpolations = {I::Linear, I::Linear},
                   .tangentWidth = 0,
                   .inTangents = {},
                   .outTangents = {}};
    std::vector<double> out(16);
    makeCurve(keys).evaluate(0.5, Side::Right, out);  // grows where it will stand, and does not turn
    EXPECT_NEAR(out[0], 0.0, 1e-12);
    EXPECT_NEAR(out[4], 0.5, 1e-12);
    std::fill(keys.values.begin(), keys.values.end(), 0.0);
    makeCurve(keys).evaluate(0.5, Side::Right, out);
    EXPECT_NEAR(out[0], 0.0, 1e-12);
}

}  // namespace
}  // namespace walkcycle
