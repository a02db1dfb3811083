#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/curves/Curve.h"
#include "loaders/curves/CurveBuilder.h"

namespace walkcycle {
namespace {

struct ReferencePoint {
    double seconds, value;
};
#include "loaders/CurveReference.inc"

using I = Interpolation;

CurveKeys uneven(I interpolation) {
    return {.width = 1,
            .times = {0.25, 1.0, 1.75, 3.5},
            .values = {1.0, 4.0, -2.0, 3.0},
            .interpolations = {interpolation, interpolation, interpolation, interpolation},
            .tangentWidth = 0,
            .inTangents = {},
            .outTangents = {}};
}

CurveKeys even(I interpolation) {
    CurveKeys keys = uneven(interpolation);
    keys.times = {0.5, 1.0, 1.5, 2.0, 2.5};
    keys.values = {2.0, -1.0, 5.0, 0.5, 3.0};
    keys.interpolations.push_back(interpolation);
    return keys;
}

double at(const Curve& curve, double seconds, Side side = Side::Right) {
    std::vector<double> out(curve.width);
    curve.evaluate(seconds, side, out);
    return out[0];
}

template <std::size_t N>
void expectCurve(const CurveKeys& keys, const ReferencePoint (&reference)[N]) {
    const Curve curve = makeCurve(keys);
    for (const ReferencePoint& point : reference)
        EXPECT_NEAR(at(curve, point.seconds), point.value, 1e-9) << "at " << point.seconds;
}

TEST(CurveTest, bezierWithHandlesOfTheirOwnTimeAgreesWithSciPy) {
    CurveKeys keys = uneven(I::Bezier);
    keys.tangentWidth = 2;
    keys.outTangents = {0.4, 3, 1.3, 6, 2.9, -4, 0, 0};
    keys.inTangents = {0, 0, 0.9, 4.5, 1.45, -2, 3, 9};
    expectCurve(keys, kBezierPairs);
}

TEST(CurveTest, bezierWithOneNumberPerTangentHasItsHandlesAtTheThirds) {
    CurveKeys keys = uneven(I::Bezier);
    keys.tangentWidth = 1;
    keys.outTangents = {3, 6, -4, 0};
    keys.inTangents = {0, 4.5, -2, 9};
    expectCurve(keys, kBezierValues);
}

TEST(CurveTest, hermiteWithOneNumberPerTangentAgreesWithSciPy) {
    CurveKeys keys = uneven(I::Hermite);
    keys.tangentWidth = 1;  // slope times the segment's length
    keys.outTangents = {2.0 * 0.75, -3.0 * 0.75, 0.5 * 1.75, 0};
    keys.inTangents = {0, -3.0 * 0.75, 0.5 * 0.75, 4.0 * 1.75};
    expectCurve(keys, kHermite);
}

TEST(CurveTest, hermiteWithTimesInItsTangentsAgreesWithSciPy) {
    CurveKeys keys = uneven(I::Hermite);
    keys.tangentWidth = 2;
    keys.outTangents = {0.3, 2, 1.2, -5, 3, 1, 0, 0};
    keys.inTangents = {0, 0, 1.5, 4, 0.2, 0, 1, -6};
    expectCurve(keys, kHermitePairs);
}

TEST(CurveTest, cardinalIsCatmullRom) {
    expectCurve(even(I::Cardinal), kCardinal);
}

TEST(CurveTest, bsplineAgreesWithSciPy) {
    expectCurve(even(I::BSpline), kBSpline);
    expectCurve(uneven(I::BSpline), kBSplineUneven);
}

TEST(CurveTest, everyKindHoldsItsFirstAndLastValueOutsideTheKeys) {
    for (I interpolation : {I::Linear, I::Step, I::Cardinal, I::BSpline}) {
        const Curve curve = makeCurve(uneven(interpolation));
        EXPECT_DOUBLE_EQ(at(curve, -7.0), 1.0);
        EXPECT_DOUBLE_EQ(at(curve, 3.5), 3.0);
        EXPECT_DOUBLE_EQ(at(curve, 99.0), 3.0);
    }
}

TEST(CurveTest, stepHoldsUntilTheNextKey) {
    const Curve curve = makeCurve(uneven(I::Step));
    EXPECT_DOUBLE_EQ(at(curve, 0.999999), 1.0);
    EXPECT_DOUBLE_EQ(at(curve, 1.0), 4.0);
    EXPECT_DOUBLE_EQ(at(curve, 1.0, Side::Left), 1.0);
    EXPECT_TRUE(curve.holds(0.25, 1.0));
}

TEST(CurveTest, eachSegmentGoesByTheInterpolationOfItsFirstKey) {
    CurveKeys keys = uneven(I::Linear);
    keys.interpolations = {I::Step, I::Linear, I::Bezier, I::Linear};
    keys.tangentWidth = 1;
    keys.outTangents = {0, 0, -4, 0};
    keys.inTangents = {0, 0, 0, 9};
    const Curve curve = makeCurve(keys);
    EXPECT_DOUBLE_EQ(at(curve, 0.9), 1.0);
    EXPECT_DOUBLE_EQ(at(curve, 1.375), 1.0);
    EXPECT_NEAR(at(curve, kBezierValues[9].seconds), kBezierValues[9].value, 1e-9);
}

TEST(CurveTest, twoKeysAtOneTimeAreAJump) {
    CurveKeys keys = uneven(I::Linear);
    keys.times = {0.0, 1.0, 1.0, 2.0};
    const Curve curve = makeCurve(keys);
    EXPECT_DOUBLE_EQ(at(curve, 1.0, Side::Left), 4.0);
    EXPECT_DOUBLE_EQ(at(curve, 1.0), -2.0);
    EXPECT_TRUE(curve.mayJump());
}

TEST(CurveTest, handlesThatPassTheNextKeyDoNotTurnTimeBack) {
    CurveKeys keys = uneven(I::Bezier);
    keys.tangentWidth = 2;
    keys.outTangents = {9, 1, 9, 4, 9, -2, 0, 0};
    keys.inTangents = {0, 0, -9, 4, -9, -2, -9, 3};
    const Curve curve = makeCurve(keys);
    double previous = at(curve, 0.25);
    for (double t = 0.25; t <= 1.0; t += 0.01) {
        EXPECT_GE(at(curve, t), previous - 1e-12);
        previous = at(curve, t);
    }
}

TEST(CurveTest, eachComponentHasHandlesOfItsOwn) {
    CurveKeys keys{.width = 2,
                   .times = {0, 3},
                   .values = {0, 10, 3, 40},
                   .interpolations = {I::Bezier, I::Bezier},
                   .tangentWidth = 4,
                   .inTangents = {0, 0, 0, 0, 2, 2, 2, 30},
                   .outTangents = {1, 1, 1, 20, 0, 0, 0, 0}};
    const Curve curve = makeCurve(keys);
    std::vector<double> out(2);
    curve.evaluate(1.2, Side::Right, out);
    EXPECT_NEAR(out[0], 1.2, 1e-12);
    EXPECT_NEAR(out[1], 22.0, 1e-12);
}

TEST(CurveTest, infinitiesGoOnAsMayaNamesThem) {
    Curve curve = makeCurve(uneven(I::Linear));  // 3.25 seconds long, rises by 2
    curve.before = curve.after = Infinity::Cycle;
    EXPECT_NEAR(at(curve, 0.5 + 3.25), at(curve, 0.5), 1e-12);
    EXPECT_NEAR(at(curve, 0.5 - 6.5), at(curve, 0.5), 1e-12);
    curve.after = Infinity::CycleRelative;
    EXPECT_NEAR(at(curve, 0.5 + 6.5), at(curve, 0.5) + 4.0, 1e-12);
    curve.after = Infinity::Oscillate;
    EXPECT_NEAR(at(curve, 3.5 + 0.2), at(curve, 3.5 - 0.2), 1e-12);
    curve.after = Infinity::Linear;
    EXPECT_NEAR(at(curve, 5.25), 8.0, 1e-12);
    std::vector<double> knots;
    curve.knots(-3.25, 3.5, 100, knots);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    EXPECT_THAT(knots, testing::ElementsAre(-3.0, -2.25, -1.5, 0.25, 1.0, 1.75, 3.5));
}

// A hang: so far from the keys, the next cycle is the same as the last.
TEST(CurveTest, cyclesOfNearlyNoLengthHaveAnEnd) {
    Curve curve = makeCurve({.times = {0.0, 1e-43},
                             .values = {0.0, 1.0},
                             .interpolations = {I::Linear, I::Linear},
                             .inTangents = {},
                             .outTangents = {}});
    curve.before = Infinity::Cycle;
    std::vector<double> knots;
    curve.knots(-0.1, 1.0, 100, knots);
    EXPECT_LE(knots.size(), 100u);
}

TEST(CurveTest, everyOtherCycleMirrorsTheKnotsOfWhatOscillates) {
    Curve curve = makeCurve(uneven(I::Linear));  // 0.25, 1, 1.75, 3.5
    curve.before = curve.after = Infinity::Oscillate;
    std::vector<double> knots;
    curve.knots(-3.0, 6.75, 100, knots);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    EXPECT_THAT(knots, testing::ElementsAre(-3.0, -1.25, -0.5, 0.25, 1.0, 1.75, 3.5, 5.25, 6.0, 6.75));
    EXPECT_TRUE(curve.mayJump());
}

TEST(CurveTest, whatGoesOnStraightLeavesAlongItsHandles) {
    CurveKeys keys = uneven(I::Bezier);
    keys.tangentWidth = 2;
    keys.outTangents = {0.5, 2, 1.3, 6, 2.9, -4, 0, 0};
    keys.inTangents = {0, 0, 0.9, 4.5, 1.45, -2, 3, 1};
    Curve curve = makeCurve(keys);
    curve.before = curve.after = Infinity::Linear;
    EXPECT_NEAR(at(curve, -0.75), 1.0 - 1.0 / 0.25, 1e-12);
    EXPECT_NEAR(at(curve, 4.5), 3.0 + 2.0 / 0.5, 1e-12);
    std::size_t place = 0;
    EXPECT_NEAR(curve.travel(4.0, 5.0, 0, place), 4.0, 1e-12);
    EXPECT_FALSE(curve.holds(4.0, 5.0));
    EXPECT_FALSE(curve.mayJump());
}

TEST(CurveTest, aHandleOnItsKeyHasNoDirectionSoTheOtherOneGivesIt) {
    CurveKeys keys = uneven(I::Bezier);
    keys.tangentWidth = 2;
    keys.outTangents = {0.25, 1, 1.3, 6, 2.5, 0, 0, 0};
    keys.inTangents = {0, 0, 0.75, 2, 1.45, -2, 3.5, 3};
    Curve curve = makeCurve(keys);
    curve.before = curve.after = Infinity::Linear;
    EXPECT_NEAR(at(curve, -0.75), 1.0 - 3.0 / 0.75, 1e-12);  // no handle: along the chord
    EXPECT_NEAR(at(curve, 4.5), 3.0 + 5.0 / 1.75, 1e-12);
}

TEST(CurveTest, whatEndsInAJumpOrHasOneKeyHoldsHoweverItShouldGoOn) {
    CurveKeys keys = uneven(I::Linear);
    keys.times = {0.0, 0.0, 1.0, 1.0};
    Curve jumps = makeCurve(keys);
    jumps.before = jumps.after = Infinity::Linear;
    EXPECT_DOUBLE_EQ(at(jumps, 9.0), 3.0);
    EXPECT_DOUBLE_EQ(at(jumps, -9.0), 1.0);
    EXPECT_DOUBLE_EQ(at(jumps, 0.0, Side::Left), 1.0);
    EXPECT_DOUBLE_EQ(at(jumps, 0.0), 4.0);
    Curve single = makeCurve({.times = {1.0},
                              .values = {4.0},
                              .interpolations = {I::Linear},
                              .inTangents = {},
                              .outTangents = {}});
    single.before = single.after = Infinity::Cycle;
    EXPECT_DOUBLE_EQ(at(single, 9.0), 4.0);
    EXPECT_TRUE(single.holds(0.0, 9.0));
    EXPECT_DOUBLE_EQ(bezierParameter(1.0, 1.0, 1.0, 1.0, 1.0), 0.0);
}

TEST(CurveTest, aBezierHoldsOnlyWhereItsHandlesAreLevelToo) {
    CurveKeys keys = uneven(I::Bezier);
    keys.values = {4.0, 4.0, 4.0, 4.0};
    keys.interpolations[2] = I::Linear;
    keys.tangentWidth = 1;
    keys.outTangents = {4, 5, 4, 4};
    keys.inTangents = {4, 4, 4, 4};
    const Curve curve = makeCurve(keys);
    EXPECT_TRUE(curve.holds(0.25, 1.0));
    EXPECT_FALSE(curve.holds(1.0, 1.75));
    EXPECT_TRUE(curve.holds(1.75, 3.5));
}

TEST(CurveTest, aSplineEndsWhereAnotherKindBegins) {
    CurveKeys keys = even(I::BSpline);
    keys.interpolations[2] = keys.interpolations[3] = I::Linear;
    const Curve curve = makeCurve(keys);
    EXPECT_DOUBLE_EQ(at(curve, 1.5), 5.0);  // the spline goes through its last key
    EXPECT_DOUBLE_EQ(at(curve, 1.75), 2.75);
    EXPECT_NEAR(at(curve, 1.0), (2.0 + 4 * -1.0 + 5.0) / 6, 1e-12);
}

}  // namespace
}  // namespace walkcycle
