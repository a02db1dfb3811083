#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "animation/AllocationCount.h"
#include "animation/KeyFrameSearch.h"
#include "walkcycle/animation/Animator.h"
#include "walkcycle/animation/Skin.h"

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

// What the animator keeps a pointer to must not be a temporary.
template <class Clip>
concept CanPlay = requires(Animator& animator, Clip&& clip) {
    animator.doAnimation(std::forward<Clip>(clip));
};
static_assert(std::is_constructible_v<Animator, Skeleton&>);
static_assert(std::is_constructible_v<Animator, const Skeleton&, std::vector<float>>);
static_assert(!std::is_constructible_v<Animator, Skeleton>);
static_assert(!std::is_constructible_v<Animator, const Skeleton>);
static_assert(!std::is_constructible_v<Animator, Skeleton, std::vector<float>>);
static_assert(CanPlay<Animation&> && CanPlay<const Animation&>);
static_assert(!CanPlay<Animation> && !CanPlay<const Animation>);

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
    clip.channels[0].tangents.resize(2);
    clip.channels.push_back(
        {.joint = 1, .matrixKeyFrames = {{2.0, glm::mat4(1.0f)}, {4.0, glm::mat4(2.0f)}}});
    clip.parameterTracks = {{.parameter = 0, .keyFrames = {{0.0, 0.0f}, {1.0, 1.0f}}}};
    Skin skin;
    skin.joints = {1, 0};
    skin.bindMatrices = {glm::mat4(1.0f), glm::mat4(1.0f)};
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

// Once, there and back, how fast, step by step.

class AnimatorClockTest : public testing::Test {
protected:
    AnimatorClockTest() { animator_.doAnimation(clip_); }

    // The pose must be that of the time.
    void expectTime(double seconds) {
        EXPECT_NEAR(animator_.time(), seconds, 1e-12);
        EXPECT_NEAR(heightOf(animator_, 0), 10.0 * seconds, 1e-4);
    }

    const Skeleton skeleton_ = twoJoints();
    const Animation clip_ = rise(0);  // two seconds
    Animator animator_{skeleton_};
};

TEST_F(AnimatorClockTest, playedOnceAClipStaysAtItsEnd) {
    animator_.setLoopMode(LoopMode::Once);
    animator_.update(1.5);
    expectTime(1.5);
    EXPECT_FALSE(animator_.atEnd());
    animator_.update(1.0);
    expectTime(2.0);
    EXPECT_TRUE(animator_.atEnd());
    animator_.update(1.0);
    expectTime(2.0);
}

TEST_F(AnimatorClockTest, playedOnceBackwardsAClipStartsAtItsEndAndStaysAtItsStart) {
    animator_.setLoopMode(LoopMode::Once);
    animator_.setSpeed(-1.0);
    animator_.doAnimation(clip_);
    expectTime(2.0);
    EXPECT_FALSE(animator_.atEnd());
    animator_.update(0.5);
    expectTime(1.5);
    animator_.update(7.0);
    expectTime(0.0);
    EXPECT_TRUE(animator_.atEnd());
}

TEST_F(AnimatorClockTest, aClipThatLoopsNeverEnds) {
    animator_.sampleAt(4.0);
    EXPECT_FALSE(animator_.atEnd());
    EXPECT_FALSE(Animator(skeleton_).atEnd());
}

TEST_F(AnimatorClockTest, pingPongComesBackAndStartsAgain) {
    animator_.setLoopMode(LoopMode::PingPong);
    animator_.update(2.0);
    expectTime(2.0);
    animator_.update(0.5);
    expectTime(1.5);
    animator_.update(2.0);
    expectTime(0.5);
    animator_.update(1e6 * 4.0);
    expectTime(0.5);
}

TEST_F(AnimatorClockTest, seekingBeyondTheClipIsWhatTheLoopModeMakesOfIt) {
    animator_.setTime(2.5);
    expectTime(0.5);
    animator_.setLoopMode(LoopMode::Once);
    animator_.setTime(2.5);
    expectTime(2.0);
    animator_.setTime(-1.0);
    expectTime(0.0);
    animator_.setLoopMode(LoopMode::PingPong);
    animator_.setTime(2.5);
    expectTime(1.5);
}

TEST_F(AnimatorClockTest, seekingTakesNoNoticeOfTheSpeed) {
    animator_.setSpeed(4.0);
    animator_.setTime(0.5);
    expectTime(0.5);
    animator_.update(0.25);
    expectTime(1.5);
}

TEST_F(AnimatorClockTest, aStepBackFromTheStartWrapsOnlyWhereTheClipLoops) {
    animator_.step(-0.25);
    expectTime(1.75);
    for (const LoopMode mode : {LoopMode::Once, LoopMode::PingPong}) {
        animator_.setLoopMode(mode);
        animator_.setTime(0.0);
        animator_.step(-0.25);
        expectTime(0.0);
        animator_.setTime(1.875);
        animator_.step(0.25);
        expectTime(2.0);
    }
}

TEST_F(AnimatorClockTest, onTheWayBackAStepOnStillMeansLaterInTheClip) {
    animator_.setLoopMode(LoopMode::PingPong);
    animator_.update(3.0);
    expectTime(1.0);
    animator_.step(0.25);
    expectTime(1.25);
    animator_.update(0.5);  // and it still goes back
    expectTime(0.75);
    animator_.step(-0.75);
    expectTime(0.0);
    animator_.update(0.5);
    expectTime(0.5);
}

TEST_F(AnimatorClockTest, stepsTakeNoNoticeOfTheSpeed) {
    animator_.setSpeed(-3.0);
    animator_.step(0.25);
    expectTime(0.25);
}

TEST_F(AnimatorClockTest, theSpeedHasBounds) {
    const std::pair<double, double> askedAndGot[] = {{2.0, 2.0},
                                                     {-0.5, -0.5},
                                                     {0.0, 0.0},
                                                     {1e9, Animator::kFastest},
                                                     {-1e9, -Animator::kFastest},
                                                     {1e-9, Animator::kSlowest},
                                                     {-1e-9, -Animator::kSlowest},
                                                     {std::numeric_limits<double>::infinity(), 128.0}};
    for (const auto& [asked, got] : askedAndGot) {
        animator_.setSpeed(asked);
        EXPECT_EQ(animator_.speed(), got) << asked;
    }
    animator_.setSpeed(2.0);
    animator_.setSpeed(std::nan(""));
    EXPECT_EQ(animator_.speed(), 2.0);
}

TEST_F(AnimatorClockTest, anotherLoopModeGoesOnFromTheSameTime) {
    animator_.setLoopMode(LoopMode::PingPong);
    animator_.update(3.5);
    expectTime(0.5);
    animator_.setLoopMode(LoopMode::Loop);
    expectTime(0.5);
    animator_.update(0.25);
    expectTime(0.75);
}

TEST_F(AnimatorClockTest, aTimeThatIsNoNumberIsIgnored) {
    for (const LoopMode mode : {LoopMode::Once, LoopMode::Loop, LoopMode::PingPong}) {
        animator_.setLoopMode(mode);
        animator_.setTime(0.75);
        animator_.setTime(std::nan(""));
        expectTime(0.75);
        animator_.step(std::nan(""));
        expectTime(0.75);
        animator_.update(std::nan(""));
        expectTime(0.75);
        animator_.sampleAt(std::nan(""));
        expectTime(0.75);
    }
}

TEST_F(AnimatorClockTest, atSpeedZeroEvenAnInfiniteTimeStandsStill) {
    animator_.setTime(0.75);
    animator_.setSpeed(0.0);
    animator_.update(std::numeric_limits<double>::infinity());
    expectTime(0.75);
}

// 0.4 + (1.7 - 0.4) is less than 1.7, and a key frame at the end would be missed.
TEST_F(AnimatorClockTest, atItsEndTheClipReachesItsLastKeyFrame) {
    Animation clip;
    clip.startSeconds = 0.4;
    clip.endSeconds = 1.7;
    clip.channels = {{.joint = 0, .keyFrames = {{0.4, raised(0.0f), true}, {1.7, raised(5.0f)}}}};
    animator_.setLoopMode(LoopMode::Once);
    animator_.doAnimation(clip);
    animator_.update(9.0);

    EXPECT_EQ(heightOf(animator_, 0), 5.0f);
}

// The two key frames around a time, and how far between them.

TEST(KeyFrameTest, aChannelBlendsBetweenItsKeyFrames) {
    const Channel channel{.keyFrames = {{0.0, raised(0.0f)}, {1.0, raised(2.0f)}, {3.0, raised(6.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, 0.25).position.y, 0.5f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 2.0f);
    EXPECT_FLOAT_EQ(sample(channel, 2.5).position.y, 5.0f);
}

TEST(KeyFrameTest, aChannelHoldsItsFirstAndLastKeyFramesOutside) {
    const Channel channel{.keyFrames = {{1.0, raised(1.0f)}, {2.0, raised(2.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, -5.0).position.y, 1.0f);
    EXPECT_FLOAT_EQ(sample(channel, 2.0).position.y, 2.0f);
    EXPECT_FLOAT_EQ(sample(channel, 9.0).position.y, 2.0f);
}

TEST(KeyFrameTest, aSingleKeyFrameIsThatPoseAtAllTimes) {
    const Channel channel{.keyFrames = {{0.5, raised(3.0f)}}};

    for (const double seconds : {0.0, 0.5, 1.0}) EXPECT_FLOAT_EQ(sample(channel, seconds).position.y, 3.0f);
}

TEST(KeyFrameTest, aStepHoldsUntilTheNextKeyFrame) {
    const Channel channel{.keyFrames = {{0.0, raised(0.0f), true}, {1.0, raised(2.0f)}, {2.0, raised(4.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, 0.999).position.y, 0.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 2.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.5).position.y, 3.0f);
}

TEST(KeyFrameTest, ofTwoKeyFramesAtOneTimeTheSecondCountsFromThatTimeOn) {
    const Channel channel{
        .keyFrames = {{0.0, raised(0.0f)}, {1.0, raised(1.0f)}, {1.0, raised(5.0f)}, {2.0, raised(6.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, 0.5).position.y, 0.5f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 5.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.5).position.y, 5.5f);
}

TEST(KeyFrameTest, jumpsAtTheVeryStartAndEndAreFine) {
    const Channel channel{
        .keyFrames = {{0.0, raised(9.0f)}, {0.0, raised(1.0f)}, {1.0, raised(2.0f)}, {1.0, raised(8.0f)}}};

    EXPECT_FLOAT_EQ(sample(channel, -1.0).position.y, 9.0f);
    EXPECT_FLOAT_EQ(sample(channel, 0.0).position.y, 1.0f);
    EXPECT_FLOAT_EQ(sample(channel, 1.0).position.y, 8.0f);
}

TEST(KeyFrameTest, progressionGoesFromZeroToOne) {
    EXPECT_EQ(calculateProgression(2.0, 4.0, 2.0), 0.0f);
    EXPECT_EQ(calculateProgression(2.0, 4.0, 3.5), 0.75f);
    EXPECT_EQ(calculateProgression(2.0, 4.0, 4.0), 1.0f);
    EXPECT_EQ(calculateProgression(2.0, 2.0, 2.0), 0.0f);
}

TEST(KeyFrameTest, withTangentsAChannelGoesOnCurves) {
    Channel channel{.keyFrames = {{0.0, {}}, {2.0, raised(8.0f)}}, .tangents = {{}, {}}};
    channel.tangents[1].in.position.y = 12.0f;

    EXPECT_NEAR(sample(channel, 1.0).position.y, 1.0f, 1e-5f);
}

// From the pose to the model.

// hip -> knee -> foot, one metre each, in a document whose unit is the centimetre.
Skeleton leg() {
    Skeleton skeleton;
    skeleton.joints.resize(3);
    skeleton.joints[0].localBindTransform = raised(300.0f).toMatrix();
    skeleton.joints[1].localBindTransform = raised(-100.0f).toMatrix();
    skeleton.joints[1].parent = 0;
    skeleton.joints[2].localBindTransform = raised(-100.0f).toMatrix();
    skeleton.joints[2].parent = 1;
    skeleton.rootTransform = glm::scale(glm::mat4(1.0f), glm::vec3(0.01f));
    return skeleton;
}

TEST(AnimatorTest, jointsAreCarriedByTheirParentsAndConvertedOnce) {
    const Skeleton skeleton = leg();
    const Animator animator(skeleton);

    ASSERT_EQ(animator.modelTransforms().size(), 3u);
    EXPECT_FLOAT_EQ(heightOf(animator, 0), 3.0f);
    EXPECT_FLOAT_EQ(heightOf(animator, 2), 1.0f);
    EXPECT_FLOAT_EQ(animator.modelTransforms()[2][0].x, 0.01f);
}

TEST(AnimatorTest, aRotatedHipSwingsTheFoot) {
    const Skeleton skeleton = leg();
    JointTransform hip = raised(300.0f);
    hip.rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0.0f, 0.0f, 1.0f));
    Animation clip;
    clip.channels = {{.joint = 0, .keyFrames = {{0.0, hip}}}};
    Animator animator(skeleton);
    animator.doAnimation(clip);

    EXPECT_NEAR(animator.modelTransforms()[2][3].x, 2.0f, 1e-5f);
    EXPECT_NEAR(heightOf(animator, 2), 3.0f, 1e-5f);
}

TEST(AnimatorTest, twoRootsStandApart) {
    Skeleton skeleton;
    skeleton.joints.resize(2);
    skeleton.joints[0].localBindTransform = raised(1.0f).toMatrix();
    skeleton.joints[1].localBindTransform = raised(2.0f).toMatrix();
    const Animator animator(skeleton);

    EXPECT_FLOAT_EQ(heightOf(animator, 1), 2.0f);
}

TEST(AnimatorTest, aClipMovesOnlyWhatItHasKeyFramesFor) {
    const Skeleton skeleton = twoJoints();
    Animation clip;
    clip.endSeconds = 1.0;
    clip.channels = {{.joint = 0}, {.joint = 1, .matrixKeyFrames = {{0.0, raised(4.0f).toMatrix()}}}};
    clip.parameterTracks = {{.parameter = 1, .keyFrames = {{0.0, 0.0f}, {1.0, 1.0f}}},
                            {.parameter = 0},
                            {.parameter = 9, .keyFrames = {{0.0, 1.0f}}}};
    Animator animator(skeleton, std::vector<float>{7.0f, 7.0f});
    animator.doAnimation(clip);
    animator.setTime(0.5);

    EXPECT_EQ(animator.pose().localTransform(0), glm::mat4(1.0f));
    EXPECT_FLOAT_EQ(animator.pose().localTransform(1)[3].y, 4.0f);
    EXPECT_FLOAT_EQ(animator.parameters()[0], 7.0f);
    EXPECT_FLOAT_EQ(animator.parameters()[1], 0.5f);
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

TEST(AnimatorTest, backwardsOnceIsNotAtItsEndBeforeTheStart) {
    Skeleton skeleton;
    skeleton.joints.resize(1);
    Animation clip;
    clip.endSeconds = 2.0;
    Animator animator(skeleton);
    animator.setLoopMode(LoopMode::Once);
    animator.setSpeed(-1.0);
    animator.doAnimation(clip);
    animator.setTime(0.25);
    EXPECT_FALSE(animator.atEnd());
    animator.update(0.25);
    EXPECT_TRUE(animator.atEnd());
}

TEST(AnimatorTest, aShortClipLoops) {
    EXPECT_DOUBLE_EQ(loop(0.375, 0.25), 0.125);
}

}  // namespace
}  // namespace walkcycle
