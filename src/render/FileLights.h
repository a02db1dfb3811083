#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "walkcycle/render/AnimatedModel.h"
#include "walkcycle/render/Camera.h"

namespace walkcycle {

// The document's lights at one moment, in the form that fileFragment.glsl reads: four texels per light,
//     position and 1, or the direction towards a directional light and 0
//     direction of a spot, and the cosine of half its cone's angle (-2: not a spot)
//     colour times intensity, falloff exponent
//     constant, linear and quadratic attenuation, per metre
// Everything is in model space. A document without lights gets a white directional light that shines along the camera's
// direction.
class FileLights {
public:
    // Takes the lights of the model's present pose. Reuses the memory of the last call.
    void gather(const AnimatedModel& model, const Camera& camera);

    const glm::vec3& ambient() const {
        return ambient_;
    }  // the sum of all ambient lights, which have no texels
    const std::vector<glm::vec4>& texels() const { return texels_; }
    int count() const { return static_cast<int>(texels_.size() / 4); }

private:
    void add(const SceneLight& light, const glm::mat4& nodeTransform, float metersPerUnit);

    glm::vec3 ambient_{0.0f};
    std::vector<glm::vec4> texels_;
};

}  // namespace walkcycle
