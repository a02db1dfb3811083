#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "crowd/TimelineBuilder.h"

namespace walkcycle {
namespace {

Channel moving(int joint, std::vector<double> times, float by = 1.0f) {
    Channel channel{.joint = joint};
    for (const double seconds : times)
        channel.keyFrames.push_back({seconds, {.position = {by * static_cast<float>(seconds), 0.0f, 0.0f}}});
    return channel;
}

std::vector<ClipTimeline> timelinesOf(std::vector<Channel> channels, const std::vector<int>& slots) {
    Animation clip;
    clip.channels = std::move(channels);
    return makeTimelines(clip, slots);
}

TEST(TimelineBuilderTest, likeTimesShareATimeline) {
    const auto timelines = timelinesOf({moving(0, {0.0, 1.0}), moving(1, {0.0, 1.0})}, {0, 1});
    ASSERT_EQ(timelines.size(), 1u);
    EXPECT_EQ(timelines[0].times, (std::vector<double>{0.0, 1.0}));
    EXPECT_EQ(timelines[0].groups.size(), 1u);
}

// Only the later channel of a joint is laid out, whichever of the two has more keys: the other one's times are not in
// the table.
TEST(TimelineBuilderTest, ofTwoChannelsForOneJointTheLaterCounts) {
    EXPECT_EQ(timelinesOf({moving(0, {0.0, 1.0}), moving(0, {0.0, 0.5, 1.0})}, {0})[0].groups.size(), 1u);
    const auto timelines = timelinesOf({moving(0, {0.0, 0.5, 1.0}), moving(0, {0.0, 1.0}, 3.0f)}, {0});
    ASSERT_EQ(timelines.size(), 1u);
    EXPECT_EQ(timelines[0].groups.size(), 1u);
    EXPECT_EQ(timelines[0].times, (std::vector<double>{0.0, 1.0}));
    std::vector<Rows> locals(1);
    timelines[0].sample(1.0, locals);
    EXPECT_EQ(locals[0].x[3], 3.0f);
}

TEST(TimelineBuilderTest, whatNobodyAsksForIsLeftOut) {
    EXPECT_TRUE(timelinesOf({moving(0, {0.0, 1.0})}, {-1}).empty());
    EXPECT_TRUE(timelinesOf({Channel{.joint = 0}}, {0}).empty());  // it has no keys
}

TEST(TimelineBuilderTest, whatDoesNotChangeTakesNoRoomInTheRows) {
    const auto still = timelinesOf({moving(0, {0.0, 1.0}, 0.0f)}, {0});
    const auto moves = timelinesOf({moving(0, {0.0, 1.0})}, {0});
    EXPECT_EQ(still[0].width, 0u);
    EXPECT_EQ(moves[0].width, 3u);
}

}  // namespace
}  // namespace walkcycle
