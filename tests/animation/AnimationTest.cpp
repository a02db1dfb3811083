#include <gtest/gtest.h>

#include "animation/Animation.h"

namespace walkcycle {
namespace {

JointTransform raised(float height) {
    return {.position = {0.0f, height, 0.0f}};
}

TEST(AnimationTest, channelBlendsBetweenItsKeyframes) {
    const Channel channel{.keyFrames = {{0.0, raised(0.0f)}, {1.0, raised(2.0f)}, {3.0, raised(6.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, 0.25).position.y, 0.5f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 2.0f);
    EXPECT_FLOAT_EQ(sample(channel, 2.5).position.y, 5.0f);
}

TEST(AnimationTest, channelHoldsItsFirstAndLastKeyframesOutside) {
    const Channel channel{.keyFrames = {{1.0, raised(1.0f)}, {2.0, raised(2.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, -5.0).position.y, 1.0f);
    EXPECT_FLOAT_EQ(sample(channel, 2.0).position.y, 2.0f);
    EXPECT_FLOAT_EQ(sample(channel, 9.0).position.y, 2.0f);
}

TEST(AnimationTest, channelWithOneKeyframeIsThatPoseAtAllTimes) {
    const Channel channel{.keyFrames = {{0.5, raised(3.0f)}}};

    for (const double seconds : {0.0, 0.5, 1.0}) EXPECT_FLOAT_EQ(sample(channel, seconds).position.y, 3.0f);
}

TEST(AnimationTest, stepHoldsUntilTheNextKeyframe) {
    const Channel channel{.keyFrames = {{0.0, raised(0.0f), true}, {1.0, raised(2.0f)}, {2.0, raised(4.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, 0.999).position.y, 0.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 2.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.5).position.y, 3.0f);
}

TEST(AnimationTest, ofTwoKeyframesAtOneTimeTheLaterCountsFromThatTimeOn) {
    const Channel channel{
        .keyFrames = {{0.0, raised(0.0f)}, {1.0, raised(1.0f)}, {1.0, raised(5.0f)}, {2.0, raised(6.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, 0.5).position.y, 0.5f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 5.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.5).position.y, 5.5f);
}

TEST(AnimationTest, jumpsAtTheVeryStartAndEndAreFine) {
    const Channel channel{
        .keyFrames = {{0.0, raised(9.0f)}, {0.0, raised(1.0f)}, {1.0, raised(2.0f)}, {1.0, raised(8.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, -1.0).position.y, 9.0f);
    EXPECT_FLOAT_EQ(sample(channel, 0.0).position.y, 1.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 8.0f);
}

TEST(AnimationTest, matrixKeyframesBlendNumberByNumber) {
    glm::mat4 mirrored(1.0f);
    mirrored[0].x = -1.0f;
    const Channel channel{.matrixKeyFrames = {{0.0, glm::mat4(1.0f)}, {1.0, mirrored}}};

    EXPECT_FLOAT_EQ(sampleMatrix(channel, 0.5)[0].x, 0.0f);
    EXPECT_FLOAT_EQ(sampleMatrix(channel, 0.5)[1].y, 1.0f);
}

TEST(AnimationTest, clipMovesOnlyWhatItHasKeysFor) {
    Skeleton skeleton;
    skeleton.joints.resize(3);
    Pose pose(skeleton);
    std::vector<float> parameters{7.0f, 7.0f};
    Animation clip;
    clip.channels = {{.joint = 1, .keyFrames = {{0.0, raised(4.0f)}}}, {.joint = 2}};
    clip.parameterTracks = {{.parameter = 1, .keyFrames = {{0.0, 0.0f}, {1.0, 1.0f}}}};

    sample(clip, 0.5, pose, parameters);

    EXPECT_EQ(pose.localTransform(0), glm::mat4(1.0f));
    EXPECT_FLOAT_EQ(pose.localTransform(1)[3].y, 4.0f);
    EXPECT_EQ(pose.localTransform(2), glm::mat4(1.0f));
    EXPECT_FLOAT_EQ(parameters[0], 7.0f);
    EXPECT_FLOAT_EQ(parameters[1], 0.5f);
}

TEST(AnimationTest, tracksOfParametersNobodyAskedForAreLeftOut) {
    Pose pose;
    Animation clip;
    clip.parameterTracks = {{.parameter = 3, .keyFrames = {{0.0, 1.0f}}}};

    sample(clip, 0.0, pose, {});
}

}  // namespace
}  // namespace walkcycle
