#include "walkcycle/render/Camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace walkcycle {
namespace {

constexpr float kFramingFovDegrees = 30.0f;  // narrow, since a wide angle distorts the proportions of a body
constexpr float kMargin = 1.05f;             // how much larger the picture is than the bounds
constexpr double kMinFov = 1e-3, kMaxFov = 179.0;

std::array<glm::vec3, 8> corners(const Bounds& bounds) {
    std::array<glm::vec3, 8> points;
    for (int i = 0; i < 8; ++i) {
        points[static_cast<std::size_t>(i)] = {i & 1 ? bounds.max.x : bounds.min.x,
                                               i & 2 ? bounds.max.y : bounds.min.y,
                                               i & 4 ? bounds.max.z : bounds.min.z};
    }
    return points;
}

// The bounds themselves; a cube of edge 2 around the origin in place of empty bounds, and a cube of edge 1 in place
// of a single point.
Bounds nonEmpty(const Bounds& bounds) {
    Bounds box = bounds;
    if (box.empty()) box = Bounds{glm::vec3(-1.0f), glm::vec3(1.0f)};
    if (box.diagonal() < 1e-6f) {
        box.min -= glm::vec3(0.5f);
        box.max += glm::vec3(0.5f);
    }
    return box;
}

// The axes of a camera as columns: -Z points along `direction`, and +Y is as close to `up` as possible.
glm::mat3 axesAlong(const glm::vec3& direction, const glm::vec3& up) {
    const glm::vec3 back = -glm::normalize(direction);
    glm::vec3 right = glm::cross(up, back);
    if (glm::length(right) < 1e-5f * std::max(glm::length(up), 1e-30f)) {
        right = std::abs(back.y) < 0.9f ? glm::cross(glm::vec3(0, 1, 0), back)
                                        : glm::cross(glm::vec3(0, 0, -1), back);
    }
    right = glm::normalize(right);
    return {right, glm::cross(back, right), back};
}

glm::mat4 viewFrom(const glm::mat3& axes, const glm::vec3& position) {
    const glm::mat3 rotation = glm::transpose(axes);
    glm::mat4 view(rotation);
    view[3] = glm::vec4(-(rotation * position), 1.0f);
    return view;
}

// Distances of the near and the far plane from the camera.
struct Depths {
    float near, far;
};

// Near and far planes that enclose the bounds and the ground around them. The near plane stays far enough
// away for the depth buffer's precision.
Depths depthsAround(const Bounds& bounds, const glm::mat4& view) {
    const glm::vec3 center(view * glm::vec4(bounds.center(), 1.0f));
    const float radius = bounds.diagonal() * 0.5f;
    const float far = std::max(-center.z + radius * 8.0f, radius * 1e-2f);
    const float near = std::max(-center.z - radius * 1.05f, far * 1e-4f);
    return {near, far};
}

glm::vec3 direction(CameraPreset preset) {
    switch (preset) {
        case CameraPreset::Front:
            return {0.0f, 0.0f, 1.0f};
        case CameraPreset::Side:
            return {1.0f, 0.0f, 0.0f};
        case CameraPreset::Top:
            return {0.0f, 1.0f, 0.0f};
        case CameraPreset::Iso:
            return {1.0f, 1.0f, 1.0f};
        case CameraPreset::Auto:
            break;
    }
    return {0.55f, 0.25f, 1.0f};  // a little from the side and from above
}

bool finite(const glm::mat4& matrix) {
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            if (!std::isfinite(matrix[i][j])) return false;
        }
    }
    return true;
}

// The view from a node: the inverse of its position and rotation, without its scale, shear or mirroring.
glm::mat4 rigidView(const glm::mat4& node) {
    if (!finite(node) || glm::length(glm::vec3(node[2])) < 1e-20f) return glm::mat4(1.0f);
    const glm::vec3 up =
        glm::length(glm::vec3(node[1])) < 1e-20f ? glm::vec3(0, 1, 0) : glm::normalize(glm::vec3(node[1]));
    return viewFrom(axesAlong(-glm::vec3(node[2]), up), glm::vec3(node[3]));
}

double halfTangent(double fovDegrees) {
    return std::tan(glm::radians(std::clamp(fovDegrees, kMinFov, kMaxFov)) * 0.5);
}

struct HalfSize {
    double x, y;
};

// Half the width and half the height of a camera of the file. If one is missing, the other and the camera's own aspect
// (else that of the picture) give it. If both are missing, half the height is `otherwise`.
HalfSize completed(std::optional<double> x, std::optional<double> y, std::optional<double> aspect,
                   double pictureAspect, double otherwise) {
    const double ratio = aspect && *aspect > 0.0 && std::isfinite(*aspect) ? *aspect : pictureAspect;
    if (x && y) return {*x, *y};
    if (x) return {*x, *x / ratio};
    if (y) return {*y * ratio, *y};
    return {otherwise * pictureAspect, otherwise};
}

std::optional<double> usable(const std::optional<double>& value) {
    return value && std::isfinite(*value) && *value > 0.0 ? value : std::nullopt;
}

glm::mat4 perspective(const SceneCamera& camera, double pictureAspect, Depths depths) {
    auto x = usable(camera.xfov), y = usable(camera.yfov);
    if (x) x = halfTangent(*x);
    if (y) y = halfTangent(*y);
    const HalfSize half = completed(x, y, camera.aspect, pictureAspect, halfTangent(45.0));
    const auto right = static_cast<float>(half.x) * depths.near,
               top = static_cast<float>(half.y) * depths.near;
    return glm::frustum(-right, right, -top, top, depths.near, depths.far);
}

glm::mat4 orthographic(const SceneCamera& camera, double pictureAspect, float scale, Depths depths) {
    const HalfSize half =
        completed(usable(camera.xmag), usable(camera.ymag), camera.aspect, pictureAspect, 1.0);
    const auto right = static_cast<float>(half.x) * scale, top = static_cast<float>(half.y) * scale;
    return glm::ortho(-right, right, -top, top, depths.near, depths.far);
}

}  // namespace

glm::vec3 Camera::position() const {
    return glm::vec3(glm::inverse(view)[3]);
}

glm::vec3 Camera::direction() const {
    return -glm::normalize(glm::vec3(view[0][2], view[1][2], view[2][2]));
}

Camera Camera::shifted(const glm::vec2& pixels, int pictureWidth, int pictureHeight) const {
    const glm::vec3 shift(-2.0f * pixels.x / static_cast<float>(pictureWidth),
                          -2.0f * pixels.y / static_cast<float>(pictureHeight), 0.0f);
    Camera moved = *this;
    moved.projection = glm::translate(glm::mat4(1.0f), shift) * projection;
    return moved;
}

Camera Camera::framing(const Bounds& bounds, float aspect, CameraPreset preset) {
    return framingFrom(bounds, aspect, walkcycle::direction(preset));
}

Camera Camera::framingFrom(const Bounds& wanted, float aspect, const glm::vec3& towardsCamera,
                           const glm::vec3& up) {
    const Bounds bounds = nonEmpty(wanted);
    const glm::mat3 axes = axesAlong(-towardsCamera, up);
    const float halfY = std::tan(glm::radians(kFramingFovDegrees) * 0.5f), halfX = halfY * aspect;

    // The camera must be far enough away to see each corner.
    float distance = 0.0f;
    for (const glm::vec3& corner : corners(bounds)) {
        const glm::vec3 p = (corner - bounds.center()) * axes;
        distance = std::max(
            {distance, p.z + std::abs(p.x) * kMargin / halfX, p.z + std::abs(p.y) * kMargin / halfY});
    }
    Camera camera;
    camera.view = viewFrom(axes, bounds.center() + axes[2] * distance);
    const Depths depths = depthsAround(bounds, camera.view);
    camera.projection = glm::perspective(glm::radians(kFramingFovDegrees), aspect, depths.near, depths.far);
    return camera;
}

Camera Camera::lookAt(const glm::vec3& position, const glm::vec3& focalPoint, const glm::vec3& up,
                      float verticalFovDegrees, float aspect, const Bounds& bounds) {
    const glm::vec3 towards = focalPoint - position;
    Camera camera;
    camera.view =
        viewFrom(axesAlong(glm::length(towards) > 0.0f ? towards : glm::vec3(0, 0, -1), up), position);
    const Depths depths = depthsAround(nonEmpty(bounds), camera.view);
    const float fov =
        std::clamp(verticalFovDegrees, static_cast<float>(kMinFov), static_cast<float>(kMaxFov));
    camera.projection = glm::perspective(glm::radians(fov), aspect, depths.near, depths.far);
    return camera;
}

Camera Camera::ofScene(const SceneCamera& optics, const glm::mat4& nodeTransform, const Skeleton& skeleton,
                       float aspect) {
    const float scale = rootScale(skeleton);
    const auto sane = [](double value, double otherwise) { return std::isfinite(value) ? value : otherwise; };
    const double far = sane(optics.zfar, 1000.0);
    const double least = optics.orthographic ? sane(optics.znear, 0.0) : std::abs(far) * 1e-7;
    const double near = std::max(sane(optics.znear, 0.1), least);
    Depths depths{static_cast<float>(near) * scale, static_cast<float>(far) * scale};
    if (!optics.orthographic) depths.near = std::max(depths.near, 1e-6f);
    if (!(depths.far > depths.near))
        depths.far = depths.near + std::max(1000.0f * scale, depths.near * 10000.0f);

    Camera camera;
    camera.view = rigidView(nodeTransform);
    camera.orthographic = optics.orthographic;
    camera.projection = optics.orthographic ? walkcycle::orthographic(optics, aspect, scale, depths)
                                            : walkcycle::perspective(optics, aspect, depths);
    return camera;
}

float rootScale(const Skeleton& skeleton) {
    const float volume = std::abs(glm::determinant(glm::mat3(skeleton.rootTransform)));
    return volume > 0.0f && std::isfinite(volume) ? std::cbrt(volume) : 1.0f;
}

}  // namespace walkcycle
