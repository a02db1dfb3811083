#pragma once

#include <optional>
#include <string>

#include "app/Arguments.h"
#include "walkcycle/render/AnimatedModel.h"
#include "walkcycle/render/Camera.h"

namespace walkcycle {

// The camera options of `render`. They name a camera of the file or a preset, or give a position and a focal point.
class CameraChoice {
public:
    void declare(Arguments& arguments);

    // Throws UsageError if --camera names no camera; the message lists all cameras.
    void check(const Model& model) const;

    // The camera for the model's present pose. For turntables, a camera that is not one of the file is moved around
    // the model by `orbitRadians`, about a vertical axis. `aspect` is the picture's width / height.
    Camera camera(const AnimatedModel& model, float aspect, float orbitRadians = 0.0f) const;

private:
    bool isPlaced() const { return position_ || focalPoint_ || up_ || angle_; }
    Camera placedCamera(const AnimatedModel& model, float aspect, float orbitRadians) const;

    std::string name_;
    std::optional<glm::vec3> position_, focalPoint_, up_;
    std::optional<float> angle_;
};

}  // namespace walkcycle
