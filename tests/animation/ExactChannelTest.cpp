#include <gmock/gmock.h>

#include "animation/ExactChannel.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Side = ExactChannel::Side;

KeyFrame keyAt(double seconds, float x, bool isStep = false) {
    return {seconds, {.position = {x, 0.0f, 0.0f}}, isStep};
}

double positionAt(const ExactChannel& channel, double seconds, Side side = Side::Right) {
    return channel.transformAt(seconds, side).position.x;
}

TEST(ExactChannelTest, aStepUpToTheLastKeyJumpsThere) {
    const Channel keys{.joint = 0, .keyFrames = {keyAt(0.0, 1.0f), keyAt(1.0, 2.0f, true), keyAt(2.0, 5.0f)}};
    const ExactChannel channel(keys);
    EXPECT_THAT(channel.times(), ElementsAre(0.0, 1.0, 2.0));
    EXPECT_THAT(channel.jumps(), ElementsAre(2.0));
    EXPECT_EQ(positionAt(channel, 0.5), 1.5);
    EXPECT_EQ(positionAt(channel, 1.5), 2.0);
    EXPECT_EQ(positionAt(channel, 2.0, Side::Left), 2.0);
    EXPECT_EQ(positionAt(channel, 2.0, Side::Right), 5.0);
}

TEST(ExactChannelTest, aStepKeyAtTheEndHolds) {
    const Channel keys{.joint = 0, .keyFrames = {keyAt(0.0, 1.0f), keyAt(1.0, 2.0f, true)}};
    const ExactChannel channel(keys);
    EXPECT_THAT(channel.times(), ElementsAre(0.0, 1.0));
    EXPECT_THAT(channel.jumps(), IsEmpty());
    EXPECT_EQ(positionAt(channel, 1.0), 2.0);
    EXPECT_EQ(positionAt(channel, 9.0), 2.0);
}

TEST(ExactChannelTest, twoKeysAtOneTimeAreAJump) {
    const Channel keys{.joint = 0, .keyFrames = {keyAt(0.0, 1.0f), keyAt(1.0, 2.0f), keyAt(1.0, 7.0f)}};
    const ExactChannel channel(keys);
    EXPECT_THAT(channel.times(), ElementsAre(0.0, 1.0));
    EXPECT_THAT(channel.jumps(), ElementsAre(1.0));
    EXPECT_EQ(positionAt(channel, 1.0, Side::Left), 2.0);
    EXPECT_EQ(positionAt(channel, 1.0, Side::Right), 7.0);
}

TEST(ExactChannelTest, matrixKeysStepAndJumpAlike) {
    Channel keys{.joint = 0};
    keys.matrixKeyFrames = {{0.0, glm::mat4(1.0f), true}, {1.0, glm::mat4(3.0f), true}};
    const ExactChannel channel(keys);
    EXPECT_THAT(channel.jumps(), ElementsAre(1.0));
    EXPECT_EQ(channel.matrixAt(1.0, Side::Left)[0].x, 1.0);
    EXPECT_EQ(channel.matrixAt(1.0, Side::Right)[0].x, 3.0);
}

}  // namespace
}  // namespace walkcycle
