#include "app/OrbitCamera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace walkcycle {
namespace {

constexpr float kFovDegrees = 30.0f;
constexpr float kNearestToPole = 0.01f;  // radians; looking straight down, kUp would be no direction
constexpr float kRadiansPerHeight = glm::pi<float>();  // half a revolution per window height
constexpr float kZoomPerStep = 0.9f;
const glm::vec3 kUp(0.0f, 1.0f, 0.0f);

}  // namespace

glm::vec3 OrbitCamera::towardsCamera() const {
    return {std::cos(pitch_) * std::sin(yaw_), std::sin(pitch_), std::cos(pitch_) * std::cos(yaw_)};
}

void OrbitCamera::frame(const Bounds& bounds, float aspect) {
    bounds_ = bounds;
    const Camera framing = Camera::framing(bounds, aspect);
    const glm::vec3 back = -framing.direction();
    target_ = bounds.empty() ? glm::vec3(0.0f) : bounds.center();
    distance_ = std::max(1e-6f, glm::dot(framing.position() - target_, back));
    yaw_ = std::atan2(back.x, back.z);
    pitch_ = std::asin(std::clamp(back.y, -1.0f, 1.0f));
    // Camera::framing() may not look exactly at the middle of the bounds: take the point on its line of sight.
    target_ = framing.position() - towardsCamera() * distance_;
}

void OrbitCamera::orbit(float dx, float dy) {
    const float pole = glm::half_pi<float>() - kNearestToPole;
    yaw_ = std::remainder(yaw_ - dx * kRadiansPerHeight, glm::two_pi<float>());
    pitch_ = std::clamp(pitch_ + dy * kRadiansPerHeight, -pole, pole);
}

void OrbitCamera::pan(float dx, float dy) {
    const glm::vec3 back = towardsCamera();
    const glm::vec3 right = glm::normalize(glm::cross(kUp, back));
    // The height of the part of the scene that the window shows, at the target's distance.
    const float height = 2.0f * distance_ * std::tan(glm::radians(kFovDegrees) * 0.5f);
    target_ += (glm::cross(back, right) * dy - right * dx) * height;
}

void OrbitCamera::zoom(float steps) {
    const float nearest = std::max(1e-6f, bounds_.diagonal() * 0.01f);
    const float farthest = std::max(1.0f, bounds_.diagonal() * 100.0f);
    distance_ = std::clamp(distance_ * std::pow(kZoomPerStep, steps), nearest, farthest);
}

Camera OrbitCamera::camera(float aspect) const {
    return Camera::lookAt(target_ + towardsCamera() * distance_, target_, kUp, kFovDegrees, aspect, bounds_);
}

}  // namespace walkcycle
