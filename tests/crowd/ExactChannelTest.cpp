#include <vector>

#include <gtest/gtest.h>

#include "crowd/ExactChannel.h"

namespace walkcycle {
namespace {

using Side = ExactChannel::Side;

KeyFrame keyAt(double seconds, float x, bool step = false) {
    return {seconds, {.position = {x, 0.0f, 0.0f}}, step};
}

double xAt(const Channel& channel, double seconds, Side side = Side::Right) {
    return ExactChannel(channel).transformAt(seconds, side).position.x;
}

TEST(ExactChannelTest, holdsItsFirstAndLastKeys) {
    const Channel channel{.keyFrames = {keyAt(1.0, 3.0f), keyAt(2.0, 5.0f)}};
    EXPECT_EQ(xAt(channel, 0.0), 3.0);
    EXPECT_EQ(xAt(channel, 1.5), 4.0);
    EXPECT_EQ(xAt(channel, 2.0), 5.0);
    EXPECT_EQ(xAt(channel, 9.0), 5.0);
}

TEST(ExactChannelTest, aStepHoldsUntilTheNextKeyAndAtTheEnd) {
    const Channel channel{.keyFrames = {keyAt(1.0, 3.0f, true), keyAt(2.0, 5.0f, true)}};
    EXPECT_EQ(xAt(channel, 1.999), 3.0);
    EXPECT_EQ(xAt(channel, 2.0, Side::Left), 3.0);
    EXPECT_EQ(xAt(channel, 2.0, Side::Right), 5.0);
    EXPECT_EQ(xAt(channel, 3.0), 5.0);
    EXPECT_EQ(ExactChannel(channel).jumps(), std::vector<double>{2.0});  // none after the last key
}

TEST(ExactChannelTest, aStepUpToTheLastKeyJumpsThere) {
    const Channel channel{.keyFrames = {keyAt(0.0, 1.0f), keyAt(1.0, 2.0f, true), keyAt(2.0, 5.0f)}};
    EXPECT_EQ(ExactChannel(channel).jumps(), std::vector<double>{2.0});
    EXPECT_EQ(xAt(channel, 0.5), 1.5);
    EXPECT_EQ(xAt(channel, 1.5), 2.0);
    EXPECT_EQ(xAt(channel, 2.0, Side::Left), 2.0);
    EXPECT_EQ(xAt(channel, 2.0), 5.0);
}

TEST(ExactChannelTest, twoKeysAtOneTimeAreAJump) {
    const Channel channel{
        .keyFrames = {keyAt(1.0, 0.0f), keyAt(2.0, 1.0f), keyAt(2.0, 7.0f), keyAt(3.0, 8.0f)}};
    EXPECT_EQ(xAt(channel, 2.0, Side::Left), 1.0);
    EXPECT_EQ(xAt(channel, 2.0, Side::Right), 7.0);
    EXPECT_EQ(ExactChannel(channel).times(), (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(ExactChannel(channel).jumps(), std::vector<double>{2.0});
}

TEST(ExactChannelTest, wideRotationsGetRowsOnTheWay) {
    Channel channel{.keyFrames = {keyAt(0.0, 0.0f), keyAt(1.0, 0.0f)}};
    channel.keyFrames[1].transform.rotation = glm::angleAxis(2.0f, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(ExactChannel(channel).times().size(), 4u);  // half of 2 radians in steps of at most 0.35
    channel.keyFrames[1].transform.rotation = -channel.keyFrames[1].transform.rotation;
    EXPECT_EQ(ExactChannel(channel).times().size(), 4u);  // the same rotation
}

TEST(ExactChannelTest, matricesAreBlendedNumberByNumber) {
    const Channel channel{.matrixKeyFrames = {{0.0, glm::mat4(1.0f)}, {2.0, glm::mat4(5.0f)}}};
    EXPECT_EQ(ExactChannel(channel).matrixAt(0.5, Side::Right)[0][0], 2.0);
}

// s³ over two seconds, cut down to its second half: ((1 + t) / 2)³.
TEST(ExactChannelTest, aPartOfACurveIsACurve) {
    Channel channel{.keyFrames = {keyAt(0.0, 0.0f), keyAt(2.0, 1.0f)}, .tangents = {{}, {}}};
    channel.tangents[1].in.position.x = 1.5f;
    const ExactChannel::Cubic half = ExactChannel(channel).cubicsBetween(1.0, 2.0)[4];
    EXPECT_DOUBLE_EQ(half[0], 1.0 / 8.0);
    EXPECT_DOUBLE_EQ(half[1], 3.0 / 8.0);
    EXPECT_DOUBLE_EQ(half[2], 3.0 / 8.0);
    EXPECT_DOUBLE_EQ(half[3], 1.0 / 8.0);
}

}  // namespace
}  // namespace walkcycle
