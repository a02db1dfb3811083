#include <cmath>
#include <optional>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "walkcycle/render/Camera.h"

namespace walkcycle {
namespace {

const Bounds kBody{{-0.6f, 0.0f, -0.4f}, {0.9f, 1.9f, 2.5f}};

glm::vec3 onPicture(const Camera& camera, const glm::vec3& point) {
    const glm::vec4 clip = camera.viewProjection() * glm::vec4(point, 1.0f);
    return glm::vec3(clip) / clip.w;
}

SceneCamera perspective(std::optional<double> xfov, std::optional<double> yfov,
                        std::optional<double> aspect) {
    SceneCamera camera;
    camera.xfov = xfov;
    camera.yfov = yfov;
    camera.aspect = aspect;
    return camera;
}

SceneCamera orthographic(std::optional<double> xmag, std::optional<double> ymag,
                         std::optional<double> aspect) {
    SceneCamera camera = perspective({}, {}, aspect);
    camera.orthographic = true;
    camera.xmag = xmag;
    camera.ymag = ymag;
    return camera;
}

// How much the lens shows: half the width and height, at distance 1 for a perspective one.
glm::vec2 halfSize(const SceneCamera& optics, float pictureAspect) {
    const Camera camera = Camera::ofScene(optics, glm::mat4(1.0f), Skeleton{}, pictureAspect);
    return {1.0f / camera.projection[0][0], 1.0f / camera.projection[1][1]};
}

TEST(CameraTest, framingKeepsEveryCornerInsideThePictureFromEverySideAndAtEveryAspect) {
    for (const CameraPreset preset : {CameraPreset::Auto, CameraPreset::Front, CameraPreset::Side,
                                      CameraPreset::Top, CameraPreset::Iso}) {
        for (const float aspect : {0.3f, 1.0f, 2.5f}) {
            const Camera camera = Camera::framing(kBody, aspect, preset);
            for (int i = 0; i < 8; ++i) {
                const glm::vec3 corner{i & 1 ? kBody.max.x : kBody.min.x, i & 2 ? kBody.max.y : kBody.min.y,
                                       i & 4 ? kBody.max.z : kBody.min.z};
                const glm::vec3 p = onPicture(camera, corner);
                EXPECT_LT(std::abs(p.x), 1.0f);
                EXPECT_LT(std::abs(p.y), 1.0f);
                EXPECT_LT(std::abs(p.z), 1.0f);
            }
        }
    }
}

TEST(CameraTest, theFrontIsSeenFromPlusZAndTheTopFromAbove) {
    EXPECT_GT(Camera::framing(kBody, 1.0f, CameraPreset::Front).position().z, kBody.max.z);
    EXPECT_GT(Camera::framing(kBody, 1.0f, CameraPreset::Top).position().y, kBody.max.y);
    EXPECT_GT(Camera::framing(kBody, 1.0f, CameraPreset::Side).position().x, kBody.max.x);
}

TEST(CameraTest, nothingToFrameStillGivesACamera) {
    const Camera camera = Camera::framing(Bounds{}, 1.0f);
    EXPECT_TRUE(std::isfinite(camera.viewProjection()[3][2]));
}

TEST(CameraTest, lookAtPutsTheFocalPointInTheMiddleAndUpUpwards) {
    const Camera camera = Camera::lookAt({1, 2, 5}, {0, 1, 0}, {0, 1, 0}, 40.0f, 1.5f, kBody);
    const glm::vec3 middle = onPicture(camera, {0, 1, 0});
    EXPECT_NEAR(middle.x, 0.0f, 1e-5f);
    EXPECT_NEAR(middle.y, 0.0f, 1e-5f);
    EXPECT_GT(onPicture(camera, {0, 1.5f, 0}).y, 0.1f);
    EXPECT_NEAR(1.0f / camera.projection[1][1], std::tan(20.0f * 3.14159265f / 180.0f), 1e-5f);
}

TEST(CameraTest, lookingStraightDownWithUpAlongTheViewIsStillACamera) {
    const Camera camera = Camera::lookAt({0, 5, 0}, {0, 0, 0}, {0, 1, 0}, 40.0f, 1.0f, kBody);
    EXPECT_NEAR(onPicture(camera, {0, 0, 0}).x, 0.0f, 1e-5f);
}

TEST(CameraTest, ofXfovYfovAndAspectEachPairMakesTheLens) {
    constexpr float tan30 = 0.57735027f;
    const auto close = [](const glm::vec2& got, float x, float y) {
        EXPECT_NEAR(got.x, x, 1e-5f);
        EXPECT_NEAR(got.y, y, 1e-5f);
    };
    close(halfSize(perspective(60, {}, {}), 2.0f), tan30, tan30 / 2);  // the picture's aspect
    close(halfSize(perspective({}, 60, {}), 2.0f), tan30 * 2, tan30);
    close(halfSize(perspective(60, {}, 1.5), 2.0f), tan30, tan30 / 1.5f);  // the camera's own
    close(halfSize(perspective({}, 60, 1.5), 2.0f), tan30 * 1.5f, tan30);
    close(halfSize(perspective(60, 60, {}), 2.0f), tan30, tan30);
}

TEST(CameraTest, ofXmagYmagAndAspectEachPairMakesTheLens) {
    const auto close = [](const glm::vec2& got, float x, float y) {
        EXPECT_NEAR(got.x, x, 1e-4f);
        EXPECT_NEAR(got.y, y, 1e-4f);
    };
    close(halfSize(orthographic(50, {}, {}), 2.0f), 50.0f, 25.0f);
    close(halfSize(orthographic({}, 50, {}), 2.0f), 100.0f, 50.0f);
    close(halfSize(orthographic(50, {}, 1.25), 2.0f), 50.0f, 40.0f);
    close(halfSize(orthographic(50, 30, {}), 2.0f), 50.0f, 30.0f);
}

TEST(CameraTest, aNodesScaleAndMirroringDoNotBendItsCamera) {
    const glm::mat4 place = glm::rotate(glm::translate(glm::mat4(1.0f), {1, 2, 3}), 0.5f, {0, 1, 0});
    const Camera plain = Camera::ofScene(perspective({}, 40, {}), place, Skeleton{}, 1.0f);
    const Camera scaled =
        Camera::ofScene(perspective({}, 40, {}), glm::scale(place, {-3.0f, 2.0f, 7.0f}), Skeleton{}, 1.0f);
    for (int i = 0; i < 4; ++i) EXPECT_LT(glm::length(plain.view[i] - scaled.view[i]), 1e-5f);
}

TEST(CameraTest, planesAndMagnificationsAreInDocumentUnits) {
    Skeleton centimetres;
    centimetres.rootTransform = glm::scale(glm::mat4(1.0f), glm::vec3(0.01f));
    SceneCamera optics = orthographic(50, 50, {});
    optics.znear = 100.0;
    optics.zfar = 300.0;
    const Camera camera = Camera::ofScene(optics, glm::mat4(1.0f), centimetres, 1.0f);
    EXPECT_NEAR(onPicture(camera, {0.5f, 0.0f, -1.0f}).x, 1.0f, 1e-5f);
    EXPECT_NEAR(onPicture(camera, {0.0f, 0.0f, -1.0f}).z, -1.0f, 1e-5f);
    EXPECT_NEAR(onPicture(camera, {0.0f, 0.0f, -3.0f}).z, 1.0f, 1e-5f);
}

}  // namespace
}  // namespace walkcycle
