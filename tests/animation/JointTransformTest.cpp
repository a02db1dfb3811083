#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "walkcycle/animation/JointTransform.h"

namespace walkcycle {
namespace {

constexpr glm::vec3 kUp{0.0f, 1.0f, 0.0f};

JointTransform turnedBy(float degrees) {
    return {.rotation = glm::angleAxis(glm::radians(degrees), kUp)};
}

float degreesOf(const JointTransform& transform) {
    const glm::vec3 forward = transform.rotation * glm::vec3(0.0f, 0.0f, 1.0f);
    return glm::degrees(std::atan2(forward.x, forward.z));
}

TEST(JointTransformTest, scalesFirstThenTurnsThenMoves) {
    const JointTransform transform{
        .position = {10.0f, 0.0f, 0.0f}, .rotation = turnedBy(90.0f).rotation, .scale = {1.0f, 1.0f, 2.0f}};

    const glm::vec4 point = transform.toMatrix() * glm::vec4(0.0f, 0.0f, 1.0f, 1.0f);

    EXPECT_NEAR(point.x, 12.0f, 1e-5f);
    EXPECT_NEAR(point.y, 0.0f, 1e-5f);
    EXPECT_NEAR(point.z, 0.0f, 1e-5f);
}

TEST(JointTransformTest, positionsAndScalesGoInAStraightLine) {
    const JointTransform a{.position = {0.0f, 2.0f, 0.0f}, .scale = {1.0f, 1.0f, 1.0f}};
    const JointTransform b{.position = {4.0f, 2.0f, 0.0f}, .scale = {3.0f, 1.0f, 1.0f}};

    const JointTransform quarter = JointTransform::interpolate(a, b, 0.25f);

    EXPECT_FLOAT_EQ(quarter.position.x, 1.0f);
    EXPECT_FLOAT_EQ(quarter.position.y, 2.0f);
    EXPECT_FLOAT_EQ(quarter.scale.x, 1.5f);
}

TEST(JointTransformTest, rotationsTurnAtConstantSpeed) {
    for (const float progression : {0.0f, 0.1f, 0.25f, 0.5f, 0.9f, 1.0f}) {
        const JointTransform between =
            JointTransform::interpolate(turnedBy(0.0f), turnedBy(170.0f), progression);
        EXPECT_NEAR(degreesOf(between), 170.0f * progression, 1e-3f) << progression;
    }
}

TEST(JointTransformTest, rotationsTakeTheShortWayRound) {
    JointTransform other = turnedBy(40.0f);
    other.rotation = -other.rotation;  // the same rotation, written the other way

    EXPECT_NEAR(degreesOf(JointTransform::interpolate(turnedBy(0.0f), other, 0.5f)), 20.0f, 1e-3f);
}

TEST(JointTransformTest, rotationsThatHardlyDifferStayOfUnitLengthAndInBetween) {
    for (const float degrees : {0.0f, 1e-5f, 1e-3f, 0.01f, 0.05f}) {
        const JointTransform between = JointTransform::interpolate(turnedBy(0.0f), turnedBy(degrees), 0.5f);
        EXPECT_NEAR(glm::length(between.rotation), 1.0f, 1e-6f) << degrees;
        EXPECT_NEAR(degreesOf(between), degrees * 0.5f, 1e-5f) << degrees;
    }
}

TEST(JointTransformTest, halfATurnGoesOneWayWithoutVanishing) {
    const JointTransform between = JointTransform::interpolate(turnedBy(0.0f), turnedBy(180.0f), 0.5f);

    EXPECT_NEAR(std::abs(degreesOf(between)), 90.0f, 1e-3f);
}

TEST(JointTransformTest, aQuarterRotationAboutEachAxisTakesOneAxisToTheNext) {
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 about(0.0f), from(0.0f), to(0.0f);
        about[axis] = from[(axis + 1) % 3] = to[(axis + 2) % 3] = 1.0f;
        const JointTransform quarter{.rotation = glm::angleAxis(glm::radians(90.0f), about)};
        const glm::vec3 found(quarter.toMatrix() * glm::vec4(from, 0.0f));
        EXPECT_LT(glm::length(found - to), 1e-6f) << axis;
        EXPECT_LT(glm::length(glm::vec3(quarter.toMatrix() * glm::vec4(to, 0.0f)) + from), 1e-6f) << axis;
    }
}

}  // namespace
}  // namespace walkcycle
