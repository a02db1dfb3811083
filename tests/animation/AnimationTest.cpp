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

// x(t) = t^3 on [0, 2]: its slopes are 0 and 12 per second.
TEST(AnimationTest, keysWithTangentsGoOnCubicCurves) {
    Channel channel{.keyFrames = {{0.0, {}}, {2.0, {.position = {8.0f, 0.0f, 0.0f}}}}, .tangents = {{}, {}}};
    channel.tangents[1].in.position.x = 12.0f;

    for (const double t : {0.0, 0.5, 1.0, 1.7}) EXPECT_NEAR(sample(channel, t).position.x, t * t * t, 1e-5);
    EXPECT_EQ(sample(channel, 7.0).position.x, 8.0f);
}

TEST(AnimationTest, curvedRotationsStayOfUnitLength) {
    const glm::quat turned = glm::angleAxis(1.5f, glm::vec3(0, 0, 1));
    Channel channel{.keyFrames = {{0.0, {}}, {1.0, {.rotation = turned}}}, .tangents = {{}, {}}};
    channel.tangents[0].out.rotation = glm::quat(0.0f, 0.5f, 0.0f, 0.7f);

    EXPECT_NEAR(glm::length(sample(channel, 0.4).rotation), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(sample(channel, 1.0).rotation, turned), 1.0f, 1e-6f);
}

TEST(AnimationTest, aStepHoldsAlsoBetweenCurves) {
    const Channel channel{.keyFrames = {{0.0, raised(1.0f), true}, {1.0, raised(5.0f)}},
                          .tangents = {{}, {}}};

    EXPECT_EQ(sample(channel, 0.9).position.y, 1.0f);
}

}  // namespace
}  // namespace walkcycle
