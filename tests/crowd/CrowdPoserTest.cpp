#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "animation/AllocationCount.h"
#include "walkcycle/crowd/CrowdPoser.h"

namespace walkcycle {
namespace {

// A joint that rises by one a second, for ten seconds.
CrowdPoser rising(unsigned int threads) {
    Skeleton skeleton;
    skeleton.joints.resize(1);
    Skin skin;
    skin.joints = {0};
    skin.bindMatrices = {glm::mat4(1.0f)};
    Animation clip;
    clip.endSeconds = 10.0;
    clip.channels = {{.joint = 0, .keyFrames = {{0.0, {}}, {10.0, {.position = {0.0f, 10.0f, 0.0f}}}}}};
    return CrowdPoser(skeleton, clip, skin, threads);
}

float heightOf(const JointRows& joint) {
    return joint.rows[1].w;
}

TEST(CrowdPoserTest, everyCharacterIsPosedAtItsOwnTimeWithAnyNumberOfThreads) {
    std::vector<double> times;
    for (int i = 0; i < 1001; ++i) times.push_back(i * 0.007);
    for (const unsigned int threads : {0u, 1u, 2u, 7u}) {
        CrowdPoser crowd = rising(threads);
        std::vector<JointRows> palettes(times.size());
        for (int frame = 0; frame < 20; ++frame) {
            for (double& time : times) time += 0.01;
            crowd.pose(times, palettes);
            for (std::size_t i = 0; i < times.size(); ++i)
                ASSERT_NEAR(heightOf(palettes[i]), times[i], 1e-5) << threads << " threads, character " << i;
        }
        for (double& time : times) time -= 0.2;
    }
}

TEST(CrowdPoserTest, aCrowdMayBeEmptyOrSmallerThanThePortions) {
    CrowdPoser crowd = rising(3);
    crowd.pose({}, {});
    const std::vector<double> times{1.0, 2.0};
    std::vector<JointRows> palettes(2);
    crowd.pose(times, palettes);
    EXPECT_NEAR(heightOf(palettes[0]), 1.0f, 1e-6f);
    EXPECT_NEAR(heightOf(palettes[1]), 2.0f, 1e-6f);
}

TEST(CrowdPoserTest, aSingleCharacterIsPosedToo) {
    CrowdPoser crowd = rising(1);
    EXPECT_EQ(crowd.paletteSize(), 1u);
    EXPECT_EQ(crowd.lengthInSeconds(), 10.0);
    std::vector<JointRows> palette(1);
    crowd.poseOne(13.0, palette);
    EXPECT_NEAR(heightOf(palette[0]), 3.0f, 1e-6f);
}

// -1 becomes the largest unsigned number.
TEST(CrowdPoserTest, absurdlyManyThreadsAreNotStarted) {
    CrowdPoser crowd = rising(static_cast<unsigned int>(-1));
    std::vector<JointRows> palettes(1000);
    crowd.pose(std::vector<double>(1000, 2.0), palettes);
    EXPECT_NEAR(heightOf(palettes[999]), 2.0f, 1e-6f);
}

TEST(CrowdPoserTest, posingAllocatesNothing) {
    CrowdPoser crowd = rising(2);
    const std::vector<double> times(500, 1.0);
    std::vector<JointRows> palettes(500);
    crowd.pose(times, palettes);
    const std::size_t before = allocationCount();
    for (int i = 0; i < 20; ++i) crowd.pose(times, palettes);
    EXPECT_EQ(allocationCount(), before);
}

}  // namespace
}  // namespace walkcycle
