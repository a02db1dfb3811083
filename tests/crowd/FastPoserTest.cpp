#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "animation/AllocationCount.h"
#include "crowd/FastPoser.h"
#include "crowd/PoserAgreement.h"

namespace walkcycle {
namespace {

// A chain with a branch: 0 - 1 - 2 - 3, 1 - 4 - 5, and 6 which reaches no skin.
Skeleton smallTree() {
    Skeleton skeleton;
    for (const int parent : {kNoParent, 0, 1, 2, 1, 4, 0}) {
        Joint joint;
        joint.parent = parent;
        joint.localBindTransform = glm::translate(glm::mat4(1.0f), {0.1f, 0.3f, -0.2f});
        skeleton.joints.push_back(joint);
    }
    skeleton.rootTransform = glm::rotate(glm::mat4(1.0f), 1.0f, {1.0f, 0.0f, 0.0f});
    return skeleton;
}

Skin skinOf(std::vector<int> joints) {
    Skin skin;
    skin.joints = std::move(joints);
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
        skin.bindMatrices.push_back(glm::scale(
            glm::translate(glm::mat4(1.0f), {0.2f * static_cast<float>(i), -0.5f, 0.1f}), glm::vec3(0.5f)));
    return skin;
}

// Random, but the same on each run.
class Keys {
public:
    float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }

    JointTransform transform() {
        const glm::quat rotation(1.2f, number(-1, 1), number(-1, 1), number(-1, 1));
        return {.position = {number(-0.5f, 0.5f), number(-0.5f, 0.5f), number(-0.5f, 0.5f)},
                .rotation = glm::normalize(rotation),
                .scale = {number(0.95f, 1.05f), number(0.95f, 1.05f), number(0.95f, 1.05f)}};
    }

    Channel channel(int joint, const std::vector<double>& times) {
        Channel channel{.joint = joint};
        for (const double seconds : times) channel.keyFrames.push_back({seconds, transform()});
        return channel;
    }

    void addTangents(Channel& channel) {
        for (std::size_t i = 0; i < channel.keyFrames.size(); ++i) {
            KeyTangents tangents;
            for (KeyTangents::Rates* rates : {&tangents.in, &tangents.out}) {
                rates->position = {number(-1, 1), number(-1, 1), number(-1, 1)};
                rates->rotation = {number(-0.3f, 0.3f), number(-0.3f, 0.3f), number(-0.3f, 0.3f),
                                   number(-0.3f, 0.3f)};
                rates->scale = {number(-1, 1), number(-1, 1), number(-1, 1)};
            }
            channel.tangents.push_back(tangents);
        }
    }

private:
    std::mt19937 engine_{7};
};

Animation clipOf(std::vector<Channel> channels) {
    Animation clip;
    clip.startSeconds = 1.0;
    clip.endSeconds = 3.0;
    clip.channels = std::move(channels);
    return clip;
}

std::vector<double> evenTimes(int count) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(1.0 + 2.0 * i / (count - 1));
    return times;
}

TEST(FastPoserTest, aWholeBodyWithTheSameKeyTimesAgreesWithThePlainWay) {
    Keys keys;
    std::vector<Channel> channels;
    for (int joint = 0; joint < 7; ++joint) channels.push_back(keys.channel(joint, evenTimes(25)));

    expectFastAgreesWithPlain(smallTree(), clipOf(channels), skinOf({0, 1, 2, 3, 4, 5, 0}));
}

TEST(FastPoserTest, nearlyHalfATurnFromKeyToKeyAgreesToo) {
    Channel spin{.joint = 1};
    for (int i = 0; i < 5; ++i)
        spin.keyFrames.push_back(
            {1.0 + 0.5 * i,
             {.rotation = glm::angleAxis(3.1f * static_cast<float>(i), glm::vec3(0.6f, 0.0f, 0.8f))}});
    expectFastAgreesWithPlain(smallTree(), clipOf({spin}), skinOf({1, 0}));
}

TEST(FastPoserTest, everyJointMayHaveTimesOfItsOwn) {
    Keys keys;
    expectFastAgreesWithPlain(
        smallTree(),
        clipOf({keys.channel(1, {1.0, 1.0625, 1.7, 3.0}), keys.channel(2, evenTimes(1000)),
                keys.channel(3, {1.2, 2.9}), keys.channel(5, {2.0})}),
        skinOf({5, 3, 0}));
}

TEST(FastPoserTest, stepsAndJumpsHappenAtTheirTimes) {
    Keys keys;
    Channel steps = keys.channel(1, {1.0, 1.5, 2.0, 2.5, 3.0});
    for (std::size_t i : {0u, 2u}) steps.keyFrames[i].step = true;
    const Channel jump = keys.channel(2, {1.0, 1.75, 1.75, 3.0});

    expectFastAgreesWithPlain(smallTree(), clipOf({steps, jump}), skinOf({1, 2, 3, 0}));
}

TEST(FastPoserTest, jointsOnCurvesAgreeWithThePlainWay) {
    Keys keys;
    Channel curved = keys.channel(1, {1.0, 1.3, 2.0, 2.5, 3.0});
    keys.addTangents(curved);
    curved.keyFrames[3].step = true;

    expectFastAgreesWithPlain(smallTree(), clipOf({curved, keys.channel(2, evenTimes(9))}),
                              skinOf({1, 2, 0}));
}

TEST(FastPoserTest, whatOnlyAMatrixCanHoldIsBlendedNumberByNumber) {
    Channel sheared{.joint = 2};
    for (int i = 0; i < 5; ++i) {
        glm::mat4 matrix(1.0f);
        matrix[1][0] = 0.3f * static_cast<float>(i);
        matrix[3] = {0.0f, 1.0f, static_cast<float>(i), 1.0f};
        sheared.matrixKeyFrames.push_back({1.0 + 0.5 * i, matrix, i == 2});
    }
    expectFastAgreesWithPlain(smallTree(), clipOf({sheared}), skinOf({2, 3, 0}));
}

TEST(FastPoserTest, whereTheNodePlacesTheSkinBothDo) {
    Keys keys;
    Skin skin = skinOf({2, 3, 0});
    skin.placedBy = 5;
    const Animation clip = clipOf({keys.channel(4, evenTimes(5)), keys.channel(1, evenTimes(4))});
    skin.placedInRoot = smallTree().rootTransform;
    expectFastAgreesWithPlain(smallTree(), clip, skin);
    skin.placedRelativeTo = 1;
    expectFastAgreesWithPlain(smallTree(), clip, skin);
}

TEST(FastPoserTest, ofTwoChannelsForOneJointTheLaterCounts) {
    Keys keys;
    expectFastAgreesWithPlain(
        smallTree(), clipOf({keys.channel(1, evenTimes(3)), keys.channel(1, {1.0, 3.0})}), skinOf({1, 0}));
}

TEST(FastPoserTest, aClipOfOnePoseStands) {
    Keys keys;
    Animation clip = clipOf({keys.channel(1, {1.0})});
    clip.endSeconds = clip.startSeconds;
    expectFastAgreesWithPlain(smallTree(), clip, skinOf({1, 2, 0}));
}

TEST(FastPoserTest, aClipThatMovesNothingOfTheSkinLeavesItAtRest) {
    Keys keys;
    expectFastAgreesWithPlain(smallTree(), clipOf({keys.channel(6, evenTimes(3))}), skinOf({1, 2, 0}));
}

// Half a second of keys crowded into a microsecond, and one far away: a cell of time with all keys but one.
TEST(FastPoserTest, crowdedKeysAreFound) {
    Keys keys;
    std::vector<double> times;
    for (int i = 0; i < 500; ++i) times.push_back(1.0 + 1e-9 * i);
    times.push_back(3.0);
    expectFastAgreesWithPlain(smallTree(), clipOf({keys.channel(1, times)}), skinOf({1, 0}));
}

TEST(FastPoserTest, noTimeIsTooStrange) {
    Keys keys;
    const Skeleton skeleton = smallTree();
    const Animation clip = clipOf({keys.channel(1, evenTimes(5))});
    CrowdPoser poser(skeleton, clip, skinOf({1, 0}), 1);
    std::vector<JointRows> atStart(2), palette(2);
    poser.poseOne(0.0, atStart);
    for (const double seconds : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        poser.poseOne(seconds, palette);
        EXPECT_EQ(difference(palette, atStart), 0.0) << seconds;
    }
    for (const double seconds : {1e300, -1e300, 1e-320}) {
        poser.poseOne(seconds, palette);
        EXPECT_TRUE(std::isfinite(palette[0].rows[0].w)) << seconds;
    }
}

// One channel with very many keys beside very many with two must not become a table of very many by very many.
TEST(FastPoserTest, tablesStayInProportionToTheKeys) {
    Keys keys;
    Skeleton skeleton;
    std::vector<Channel> channels;
    std::vector<int> joints;
    for (int joint = 0; joint < 1000; ++joint) {
        skeleton.joints.emplace_back();
        joints.push_back(joint);
        channels.push_back(
            keys.channel(joint, joint == 0 ? evenTimes(10'000) : std::vector<double>{1.0, 3.0}));
    }
    const FastPoser poser(skeleton, clipOf(channels), skinOf(joints));

    EXPECT_LT(poser.tableBytes(), 12'000u * sizeof(KeyFrame) * 16);
}

TEST(FastPoserTest, posingAllocatesNothing) {
    Keys keys;
    const Skeleton skeleton = smallTree();
    CrowdPoser poser(skeleton, clipOf({keys.channel(1, evenTimes(5))}), skinOf({1, 0}), 1);
    std::vector<JointRows> palette(2);
    const std::size_t before = allocationCount();
    for (int i = 0; i < 100; ++i) poser.poseOne(i * 0.1, palette);
    EXPECT_EQ(allocationCount(), before);
}

}  // namespace
}  // namespace walkcycle
