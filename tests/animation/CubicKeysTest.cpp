#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "animation/CubicKeys.h"

namespace walkcycle {
namespace {

JointTransform raised(float height) {
    return {.position = {0.0f, height, 0.0f}};
}

// t^3 on [0, 2]: its slopes there are 0 and 12 per second.
TEST(CubicKeysTest, aCubicCurveIsFollowedExactly) {
    const std::vector<KeyFrame> keyFrames{{0.0, {}}, {2.0, raised(8.0f)}};
    std::vector<KeyTangents> tangents(2);
    tangents[1].in.position.y = 12.0f;
    tangents[1].out.position.y = -99.0f;  // of the stretch that would follow

    for (const double t : {0.0, 0.5, 1.0, 1.7})
        EXPECT_NEAR(sampleCubic(keyFrames, tangents, t).position.y, t * t * t, 1e-5);
    EXPECT_EQ(sampleCubic(keyFrames, tangents, 7.0).position.y, 8.0f);
    EXPECT_EQ(sampleCubic(keyFrames, tangents, -7.0).position.y, 0.0f);
}

TEST(CubicKeysTest, eachStretchHasTangentsOfItsOwn) {
    const std::vector<KeyFrame> keyFrames{{0.0, {}}, {1.0, {}}, {2.0, {}}};
    std::vector<KeyTangents> tangents(3);
    tangents[1].out.position.y = 8.0f;

    EXPECT_EQ(sampleCubic(keyFrames, tangents, 0.5).position.y, 0.0f);
    EXPECT_FLOAT_EQ(sampleCubic(keyFrames, tangents, 1.5).position.y, 1.0f);
}

TEST(CubicKeysTest, scalesAndRotationsGoOnCurvesToo) {
    const glm::quat rotated = glm::angleAxis(1.5f, glm::vec3(0, 0, 1));
    const std::vector<KeyFrame> keyFrames{{0.0, {}}, {1.0, {.rotation = rotated, .scale = glm::vec3(3.0f)}}};
    std::vector<KeyTangents> tangents(2);
    tangents[0].out.rotation = glm::quat(0.0f, 0.5f, 0.0f, 0.7f);

    EXPECT_FLOAT_EQ(sampleCubic(keyFrames, tangents, 0.25).scale.x, 1.3125f);  // flat at both ends
    EXPECT_NEAR(glm::length(sampleCubic(keyFrames, tangents, 0.4).rotation), 1.0f, 1e-6f);
    EXPECT_GT(sampleCubic(keyFrames, tangents, 0.4).rotation.x, 0.05f);
    EXPECT_NEAR(glm::dot(sampleCubic(keyFrames, tangents, 1.0).rotation, rotated), 1.0f, 1e-6f);
}

TEST(CubicKeysTest, aStepHoldsAlsoBetweenCurves) {
    const std::vector<KeyFrame> keyFrames{{0.0, raised(1.0f), true}, {1.0, raised(5.0f)}};

    EXPECT_EQ(sampleCubic(keyFrames, std::vector<KeyTangents>(2), 0.9).position.y, 1.0f);
}

}  // namespace
}  // namespace walkcycle
