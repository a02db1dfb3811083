#pragma once

#include "render/Camera.h"

namespace walkcycle {

// A camera that a mouse moves round a point, nearer and farther, and sideways.
class OrbitCamera {
public:
    // Looks at all of `bounds`, from a little to the side and above. Where `reset` comes back to.
    void frame(const Bounds& bounds, float aspect);

    // Follows a change of what there is to see without moving: only the depth range changes.
    void keep(const Bounds& bounds) { bounds_ = bounds; }

    // Movements in shares of the window's height, y downwards as the mouse has it.
    void orbit(float dx, float dy);
    void pan(float dx, float dy);
    void zoom(float steps);  // over zero: nearer

    Camera camera(float aspect) const;

private:
    glm::vec3 towardsCamera() const;

    Bounds bounds_;
    glm::vec3 target_{0.0f};
    float distance_ = 3.0f;
    float yaw_ = 0.0f, pitch_ = 0.0f;  // radians
};

}  // namespace walkcycle
