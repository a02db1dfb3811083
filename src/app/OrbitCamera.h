#pragma once

#include "walkcycle/render/Camera.h"

namespace walkcycle {

// The camera of the viewer. It looks at a target point; the mouse moves it around the target (orbit), sideways together
// with the target (pan), and to and from the target (zoom). Points and lengths are in model space.
class OrbitCamera {
public:
    // Shows all of `bounds`, from the front, a little to the side and from above (CameraPreset::Auto).
    void frame(const Bounds& bounds, float aspect);

    // Sets the bounds without moving the camera: only the depth range of camera() and the range of zoom() change.
    void keep(const Bounds& bounds) { bounds_ = bounds; }

    // Movements of the mouse as fractions of the window's height, y downwards.
    void orbit(float dx, float dy);
    void pan(float dx, float dy);
    void zoom(float steps);  // above zero: nearer

    Camera camera(float aspect) const;

private:
    glm::vec3 towardsCamera() const;

    Bounds bounds_;
    glm::vec3 target_{0.0f};
    float distance_ = 3.0f;
    float yaw_ = 0.0f, pitch_ = 0.0f;  // radians
};

}  // namespace walkcycle
