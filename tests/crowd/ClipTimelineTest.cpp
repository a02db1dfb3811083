#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "animation/CurvedTransform.h"
#include "crowd/ClipTimeline.h"
#include "crowd/TimelineBuilder.h"

namespace walkcycle {
namespace {

JointTransform transformOf(float x, float radians, float scale) {
    return {.position = {x, 2.0f * x, -x},
            .rotation = glm::angleAxis(radians, glm::vec3(0.6f, 0.0f, 0.8f)),
            .scale = {scale, 1.0f, 1.0f / scale}};
}

std::vector<ClipTimeline> timelinesOf(std::vector<Channel> channels, const std::vector<int>& slots) {
    Animation clip;
    clip.channels = std::move(channels);
    return makeTimelines(clip, slots);
}

// Five joints, which is more than one register: two keys each, one second apart.
std::vector<Channel> fiveJoints() {
    std::vector<Channel> channels;
    for (int joint = 0; joint < 5; ++joint) {
        const auto j = static_cast<float>(joint);
        channels.push_back({.joint = joint,
                            .keyFrames = {{0.0, transformOf(j, 0.1f * j, 1.0f)},
                                          {1.0, transformOf(j + 1.0f, 0.1f * j + 0.6f, 1.5f)}}});
    }
    return channels;
}

// The largest difference of any number of the joints from what `exact(channel, s)` says at progression s.
template <typename Exact>
double farthestFrom(const std::vector<Channel>& channels, Exact exact) {
    const auto timelines = timelinesOf(channels, {0, 1, 2, 3, 4});
    double farthest = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const double s = i / 100.0;
        std::vector<Rows> locals(channels.size());
        for (const ClipTimeline& timeline : timelines) timeline.sample(s, locals);
        for (std::size_t c = 0; c < channels.size(); ++c) {
            JointRows joint;
            store(locals[c], joint);
            const glm::dmat4 apart = glm::dmat4(joint.toMatrix()) - exact(channels[c], s).toMatrix();
            for (int n = 0; n < 16; ++n) farthest = std::max(farthest, std::abs(apart[n / 4][n % 4]));
        }
    }
    return farthest;
}

TEST(ClipTimelineTest, fourJointsAtATimeSlerpAsOneDoes) {
    EXPECT_LT(farthestFrom(fiveJoints(),
                           [](const Channel& channel, double s) {
                               return ExactTransform::interpolate(
                                   ExactTransform(channel.keyFrames[0].transform),
                                   ExactTransform(channel.keyFrames[1].transform), s);
                           }),
              1e-6);
}

TEST(ClipTimelineTest, fourJointsAtATimeGoOnCurvesAsOneDoes) {
    std::vector<Channel> channels = fiveJoints();
    const KeyTangents::Rates leaving{{1.0f, 0.0f, -2.0f}, {0.1f, 0.2f, 0.0f, -0.3f}, {0.5f, 0.0f, 0.0f}};
    const KeyTangents::Rates arriving{{0.0f, 3.0f, 1.0f}, {-0.2f, 0.0f, 0.1f, 0.1f}, {0.0f, 0.0f, 0.4f}};
    for (Channel& channel : channels) channel.tangents = {{{}, leaving}, {arriving, {}}};
    const auto inDouble = [](const KeyTangents::Rates& r) {
        return TransformRates<double>{r.position, r.rotation, r.scale};
    };
    EXPECT_LT(farthestFrom(channels,
                           [&](const Channel& channel, double s) {
                               return curvedTransform(ExactTransform(channel.keyFrames[0].transform),
                                                      inDouble(leaving),
                                                      ExactTransform(channel.keyFrames[1].transform),
                                                      inDouble(arriving), Hermite(s));
                           }),
              2e-6);
}

// A table of three rows: at a row's own time it rules, and beyond the ends the first and the last hold.
TEST(ClipTimelineTest, everyTimeFindsItsRow) {
    Channel rising{.joint = 0};
    for (const double seconds : {1.0, 1.5, 4.0})
        rising.keyFrames.push_back({seconds, {.position = {static_cast<float>(seconds), 0.0f, 0.0f}}});
    const auto timelines = timelinesOf({rising}, {0});
    ASSERT_EQ(timelines.size(), 1u);
    for (const auto& [seconds, height] : {std::pair{-5.0, 1.0f},
                                          {1.0, 1.0f},
                                          {1.25, 1.25f},
                                          {1.5, 1.5f},
                                          {3.0, 3.0f},
                                          {4.0, 4.0f},
                                          {99.0, 4.0f}}) {
        std::vector<Rows> locals(1);
        timelines[0].sample(seconds, locals);
        EXPECT_FLOAT_EQ(locals[0].x[3], height) << seconds;
    }
}

}  // namespace
}  // namespace walkcycle
