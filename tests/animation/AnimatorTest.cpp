#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "animation/AllocationCount.h"
#include "animation/Animator.h"
#include "animation/Skin.h"

namespace walkcycle {
namespace {

JointTransform raised(float height) {
    return {.position = {0.0f, height, 0.0f}};
}

Skeleton twoJoints() {
    Skeleton skeleton;
    skeleton.joints.resize(2);
    skeleton.joints[1].parent = 0;
    return skeleton;
}

// Rises by ten a second, from second 2 to second 4 of the document.
Animation rise(int joint) {
    Animation clip;
    clip.startSeconds = 2.0;
    clip.endSeconds = 4.0;
    clip.channels = {{.joint = joint, .keyFrames = {{2.0, raised(0.0f)}, {4.0, raised(20.0f)}}}};
    return clip;
}

float heightOf(const Animator& animator, std::size_t joint) {
    return animator.modelTransforms()[joint][3].y;
}

TEST(AnimatorTest, withoutAClipTheSkeletonRests) {
    Skeleton skeleton = twoJoints();
    skeleton.joints[1].localBindTransform = raised(3.0f).toMatrix();
    Animator animator(skeleton);
    animator.update(1.0);

    EXPECT_FLOAT_EQ(heightOf(animator, 1), 3.0f);
    EXPECT_EQ(animator.animation(), nullptr);
}

TEST(AnimatorTest, aClipStartsAtItsBeginning) {
    const Skeleton skeleton = twoJoints();
    const Animation clip = rise(0);
    Animator animator(skeleton);
    animator.doAnimation(clip);

    EXPECT_DOUBLE_EQ(animator.time(), 0.0);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 0.0f);
}

TEST(AnimatorTest, updateGoesOnAndWrapsAroundBothEnds) {
    const Skeleton skeleton = twoJoints();
    const Animation clip = rise(0);
    Animator animator(skeleton);
    animator.doAnimation(clip);

    animator.update(0.5);
    EXPECT_NEAR(heightOf(animator, 1), 5.0f, 1e-5f);  // the child is carried along
    animator.update(2.0);
    EXPECT_NEAR(heightOf(animator, 1), 5.0f, 1e-5f);
    animator.update(-1.0);
    EXPECT_NEAR(animator.time(), 1.5, 1e-12);
    EXPECT_NEAR(heightOf(animator, 1), 15.0f, 1e-5f);
}

TEST(AnimatorTest, atItsLengthPlaybackIsBackAtTheStart) {
    const Skeleton skeleton = twoJoints();
    const Animation clip = rise(0);
    Animator animator(skeleton);
    animator.doAnimation(clip);
    animator.setTime(2.0);

    EXPECT_DOUBLE_EQ(animator.time(), 0.0);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 0.0f);
}

TEST(AnimatorTest, samplingHoldsTheFirstAndLastPose) {
    const Skeleton skeleton = twoJoints();
    const Animation clip = rise(0);
    Animator animator(skeleton);
    animator.doAnimation(clip);

    animator.sampleAt(3.0);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 10.0f);
    animator.sampleAt(4.0);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 20.0f);
    animator.sampleAt(99.0);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 20.0f);
    animator.sampleAt(0.0);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 0.0f);
}

TEST(AnimatorTest, aClipOfASinglePoseStaysAtItsStart) {
    const Skeleton skeleton = twoJoints();
    Animation clip;
    clip.channels = {{.joint = 0, .keyFrames = {{0.0, raised(4.0f)}}}};
    Animator animator(skeleton);
    animator.doAnimation(clip);
    animator.update(0.7);

    EXPECT_DOUBLE_EQ(animator.time(), 0.0);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 4.0f);
}

TEST(AnimatorTest, aClipWithoutChannelsRests) {
    const Skeleton skeleton = twoJoints();
    Animation clip;
    clip.endSeconds = 1.0;
    Animator animator(skeleton);
    animator.doAnimation(clip);
    animator.update(0.5);

    EXPECT_EQ(animator.modelTransforms()[1], glm::mat4(1.0f));
}

TEST(AnimatorTest, theNextClipStartsFromRestAndNotFromTheLastOne) {
    const Skeleton skeleton = twoJoints();
    const Animation first = rise(0);
    const Animation second = rise(1);
    const std::vector<float> restParameters{0.25f};
    Animation third;
    third.parameterTracks = {{.parameter = 0, .keyFrames = {{0.0, 1.0f}}}};
    Animator animator(skeleton, restParameters);

    animator.doAnimation(first);
    animator.setTime(1.0);
    animator.doAnimation(second);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 0.0f);

    animator.doAnimation(third);
    EXPECT_FLOAT_EQ(animator.parameters()[0], 1.0f);
    animator.doAnimation(first);
    EXPECT_FLOAT_EQ(animator.parameters()[0], 0.25f);
}

TEST(AnimatorTest, aFrameAllocatesNothing) {
    const Skeleton skeleton = twoJoints();
    Animation clip = rise(0);
    clip.parameterTracks = {{.parameter = 0, .keyFrames = {{0.0, 0.0f}, {1.0, 1.0f}}}};
    Skin skin;
    skin.joints = {1, 0};
    skin.inverseBindMatrices = {glm::mat4(1.0f), glm::mat4(1.0f)};
    const std::vector<float> restParameters{0.0f};
    std::vector<glm::mat4> palette;
    Animator animator(skeleton, restParameters);
    animator.doAnimation(clip);
    computePalette(skin, animator.modelTransforms(), palette);

    const std::size_t before = allocationCount();
    for (int frame = 0; frame < 100; ++frame) {
        animator.update(1.0 / 60.0);
        computePalette(skin, animator.modelTransforms(), palette);
    }
    animator.doAnimation(clip);

    EXPECT_EQ(allocationCount(), before);
}

TEST(LoopTest, timeStaysFromZeroToJustBeforeTheLength) {
    EXPECT_DOUBLE_EQ(loop(0.25, 1.0), 0.25);
    EXPECT_DOUBLE_EQ(loop(1.0, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(loop(3.25, 1.0), 0.25);
    EXPECT_DOUBLE_EQ(loop(-0.25, 1.0), 0.75);
    EXPECT_LT(loop(-1e-30, 1.0), 1.0);
}

TEST(LoopTest, withoutALengthOrATimeItIsTheStart) {
    EXPECT_DOUBLE_EQ(loop(5.0, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(loop(5.0, -1.0), 0.0);
    EXPECT_DOUBLE_EQ(loop(std::numeric_limits<double>::infinity(), 1.0), 0.0);
    EXPECT_DOUBLE_EQ(loop(std::nan(""), 1.0), 0.0);
}

}  // namespace
}  // namespace walkcycle
