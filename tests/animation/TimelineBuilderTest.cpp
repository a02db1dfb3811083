#include <gmock/gmock.h>

#include "animation/TimelineBuilder.h"

namespace walkcycle {
namespace {

using testing::Each;
using testing::IsEmpty;
using testing::SizeIs;

Channel channelOf(int joint, int keyCount, float x) {
    Channel channel{.joint = joint};
    for (int i = 0; i < keyCount; ++i)
        channel.keyFrames.push_back({double(i) / keyCount, {.position = {x, float(i), 0.0f}}, false});
    return channel;
}

// Whichever of the two has more keys, and so a place before the other.
TEST(TimelineBuilderTest, aJointThatTwoChannelsMoveIsLaidOutOnceByTheLaterOne) {
    for (const int keysOfTheFirst : {2, 9}) {
        Animation clip;
        clip.channels = {channelOf(0, keysOfTheFirst, 1.0f), channelOf(0, 5, 2.0f)};
        const std::vector<int> slots{0};
        const std::vector<ClipTimeline> timelines = makeTimelines(clip, slots);
        ASSERT_THAT(timelines, SizeIs(1));
        ASSERT_THAT(timelines[0].groups, SizeIs(1));
        EXPECT_THAT(timelines[0].groups[0].slots, Each(0));
        EXPECT_THAT(timelines[0].times, SizeIs(5));
    }
}

TEST(TimelineBuilderTest, aJointThatNobodyAsksForIsLeftOut) {
    Animation clip;
    clip.channels = {channelOf(0, 3, 1.0f)};
    const std::vector<int> slots{-1};
    EXPECT_THAT(makeTimelines(clip, slots), IsEmpty());
}

}  // namespace
}  // namespace walkcycle
