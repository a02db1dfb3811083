#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/OrbitCamera.h"

namespace walkcycle {
namespace {

constexpr float kAspect = 16.0f / 9.0f;
const Bounds kBox{.min = {-1.0f, 0.0f, -0.5f}, .max = {1.0f, 2.0f, 0.5f}};

// Where a point is in the picture: x and y from -1 to 1.
glm::vec2 inPicture(const OrbitCamera& camera, const glm::vec3& point) {
    const glm::vec4 clip = camera.camera(kAspect).viewProjection() * glm::vec4(point, 1.0f);
    return glm::vec2(clip) / clip.w;
}

float distanceTo(const OrbitCamera& camera, const glm::vec3& point) {
    return glm::length(camera.camera(kAspect).position() - point);
}

class OrbitCameraTest : public testing::Test {
protected:
    OrbitCameraTest() { camera.frame(kBox, kAspect); }
    OrbitCamera camera;
};

TEST_F(OrbitCameraTest, framingShowsEveryCornerFromTheSameSideAsAPicture) {
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec2 at =
            inPicture(camera, {corner & 1 ? kBox.max.x : kBox.min.x, corner & 2 ? kBox.max.y : kBox.min.y,
                               corner & 4 ? kBox.max.z : kBox.min.z});
        EXPECT_LE(std::abs(at.x), 1.0f);
        EXPECT_LE(std::abs(at.y), 1.0f);
    }
    const Camera picture = Camera::framing(kBox, kAspect);
    EXPECT_LT(glm::length(camera.camera(kAspect).direction() - picture.direction()), 1e-5f);
    EXPECT_LT(glm::length(camera.camera(kAspect).position() - picture.position()), 1e-4f);
}

TEST_F(OrbitCameraTest, draggingAcrossTheWindowsHeightGoesHalfAroundAndKeepsTheDistance) {
    const glm::vec3 before = camera.camera(kAspect).direction();
    const float distance = distanceTo(camera, kBox.center());
    camera.orbit(1.0f, 0.0f);
    const glm::vec3 after = camera.camera(kAspect).direction();
    EXPECT_NEAR(after.x, -before.x, 1e-5f);
    EXPECT_NEAR(after.y, before.y, 1e-5f);
    EXPECT_NEAR(after.z, -before.z, 1e-5f);
    EXPECT_NEAR(distanceTo(camera, kBox.center()), distance, 1e-4f);
}

TEST_F(OrbitCameraTest, whatIsInFrontFollowsTheMouse) {
    const glm::vec3 nearest(0.0f, 1.0f, 0.5f);
    const glm::vec2 before = inPicture(camera, nearest);
    camera.orbit(0.02f, 0.0f);
    EXPECT_GT(inPicture(camera, nearest).x, before.x);
    camera.orbit(-0.02f, 0.02f);
    EXPECT_LT(inPicture(camera, nearest).y, before.y);
}

TEST_F(OrbitCameraTest, orbitingUpOrDownStopsBeforeThePoles) {
    for (const float far : {100.0f, -200.0f}) {
        camera.orbit(0.0f, far);
        const Camera stopped = camera.camera(kAspect);
        EXPECT_GT(std::abs(stopped.direction().y), 0.99f);
        EXPECT_LT(std::abs(stopped.direction().y), 1.0f);
        EXPECT_NEAR(inPicture(camera, kBox.center()).x, 0.0f, 1e-3f);
        const glm::vec2 up = inPicture(camera, kBox.center() + glm::vec3(0.0f, 0.5f, 0.0f));
        EXPECT_GT(up.y, inPicture(camera, kBox.center()).y) << "up stays up";
    }
}

TEST_F(OrbitCameraTest, aPannedPointStaysUnderTheMouse) {
    const glm::vec2 before = inPicture(camera, kBox.center());
    camera.pan(0.1f, 0.2f);
    const glm::vec2 moved = inPicture(camera, kBox.center()) - before;
    // The picture is 2 high; the window's y goes down, the picture's up.
    EXPECT_NEAR(moved.x, 2.0f * 0.1f / kAspect, 1e-3f);
    EXPECT_NEAR(moved.y, -2.0f * 0.2f, 1e-3f);
}

TEST_F(OrbitCameraTest, zoomingGoesNearerByTenPercentAStepAndStopsInTime) {
    const float distance = distanceTo(camera, kBox.center());
    camera.zoom(1.0f);
    EXPECT_NEAR(distanceTo(camera, kBox.center()), 0.9f * distance, 1e-3f);
    camera.zoom(-1.0f);
    EXPECT_NEAR(distanceTo(camera, kBox.center()), distance, 1e-3f);
    camera.zoom(10000.0f);
    EXPECT_NEAR(distanceTo(camera, kBox.center()), 0.01f * kBox.diagonal(), 1e-3f);
    camera.zoom(-10000.0f);
    EXPECT_NEAR(distanceTo(camera, kBox.center()), 100.0f * kBox.diagonal(), 0.1f);
}

TEST_F(OrbitCameraTest, newBoundsKeepTheViewAndCutNothingOff) {
    const glm::mat4 before = camera.camera(kAspect).view;
    const Bounds larger{.min = glm::vec3(-10.0f), .max = glm::vec3(10.0f)};
    camera.keep(larger);
    EXPECT_EQ(camera.camera(kAspect).view, before);
    const Camera kept = camera.camera(kAspect);
    const glm::vec4 clip =
        kept.viewProjection() * glm::vec4(kept.position() + kept.direction() * 20.0f, 1.0f);
    EXPECT_LE(std::abs(clip.z / clip.w), 1.0f) << "beyond the old bounds, but within the depth range";
}

TEST(OrbitCameraEmptyTest, nothingToSeeStillGivesACamera) {
    OrbitCamera camera;
    camera.frame(Bounds{}, kAspect);
    camera.orbit(0.3f, 0.1f);
    camera.zoom(2.0f);
    const glm::vec2 origin = inPicture(camera, glm::vec3(0.0f));
    EXPECT_NEAR(origin.x, 0.0f, 1e-3f);
    EXPECT_NEAR(origin.y, 0.0f, 1e-3f);
}

}  // namespace
}  // namespace walkcycle
