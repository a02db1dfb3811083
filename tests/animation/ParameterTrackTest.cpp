#include <gtest/gtest.h>

#include "animation/ParameterTrack.h"

namespace walkcycle {
namespace {

TEST(ParameterTrackTest, aNumberGoesOnAStraightLineAndHoldsOutside) {
    const ParameterTrack track{.keyFrames = {{1.0, 0.0f}, {3.0, 1.0f}}};

    EXPECT_EQ(sample(track, 0.0), 0.0f);
    EXPECT_FLOAT_EQ(sample(track, 1.5), 0.25f);
    EXPECT_EQ(sample(track, 9.0), 1.0f);
}

TEST(ParameterTrackTest, aStepHoldsUntilTheNextKeyFrame) {
    const ParameterTrack track{.keyFrames = {{0.0, 1.0f, true}, {1.0, 5.0f}}};

    EXPECT_EQ(sample(track, 0.999), 1.0f);
    EXPECT_EQ(sample(track, 1.0), 5.0f);
}

// t^3 on [0, 2], and then straight on at 12 per second.
TEST(ParameterTrackTest, withTangentsANumberGoesOnACurve) {
    const ParameterTrack track{.keyFrames = {{0.0, 0.0f}, {2.0, 8.0f}, {3.0, 20.0f}},
                               .tangents = {{0.0f, 0.0f}, {12.0f, 12.0f}, {12.0f, 0.0f}}};

    for (const double t : {0.0, 0.5, 1.0, 1.7}) EXPECT_NEAR(sample(track, t), t * t * t, 1e-5);
    EXPECT_NEAR(sample(track, 2.25), 11.0f, 1e-5f);
}

}  // namespace
}  // namespace walkcycle
