#pragma once

#include <optional>
#include <string>

#include "app/Arguments.h"
#include "render/AnimatedModel.h"
#include "render/Camera.h"

namespace walkcycle {

// The camera options of `render`: a camera of the file, a preset, or a place of one's own.
class CameraChoice {
public:
    void declare(Arguments& arguments);

    // Throws UsageError where the name means no camera; the message lists those that there are.
    void check(const Model& model) const;

    // The camera for the model as it stands now. `turn` (radians) goes round it, for turntables.
    Camera camera(const AnimatedModel& model, float aspect, float turn = 0.0f) const;

private:
    bool hasPosition() const { return position_ || focalPoint_ || up_ || angle_; }
    Camera ownCamera(const AnimatedModel& model, float aspect, float turn) const;

    std::string name_;
    std::optional<glm::vec3> position_, focalPoint_, up_;
    std::optional<float> angle_;
};

}  // namespace walkcycle
