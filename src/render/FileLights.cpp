#include "render/FileLights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace walkcycle {
namespace {

constexpr float kNoCone = -2.0f;  // below every cosine: the light shines in all directions

glm::vec3 unitOr(const glm::vec3& vector, const glm::vec3& otherwise) {
    const float length = glm::length(vector);
    return length > 0.0f && std::isfinite(length) ? vector / length : otherwise;
}

// The cosine of half the cone's angle (<falloff_angle>). A cone of 180 degrees lights everything in front of the
// spot, a cone of 360 degrees everything.
float coneCosine(const SceneLight& light) {
    return std::cos(glm::radians(std::clamp(light.falloffAngle, 0.0f, 360.0f)) * 0.5f);
}

}  // namespace

void FileLights::gather(const AnimatedModel& model, const Camera& camera) {
    texels_.clear();
    ambient_ = glm::vec3(0.0f);
    const auto& transforms = model.animator().modelTransforms();
    const float metersPerUnit = rootScale(model.model().skeleton);
    for (const LightInstance& instance : model.model().lightInstances) {
        add(model.scene().lights[static_cast<std::size_t>(instance.light)],
            transforms[static_cast<std::size_t>(instance.node)], metersPerUnit);
    }
    if (!model.model().lightInstances.empty()) return;
    texels_.insert(texels_.end(),
                   {glm::vec4(-camera.direction(), 0.0f), glm::vec4(0.0f, 0.0f, -1.0f, kNoCone),
                    glm::vec4(1.0f, 1.0f, 1.0f, 0.0f), glm::vec4(1.0f, 0.0f, 0.0f, 0.0f)});
}

void FileLights::add(const SceneLight& light, const glm::mat4& nodeTransform, float metersPerUnit) {
    const glm::vec3 color = light.color * light.intensity;
    if (light.kind == LightKind::Ambient) {
        ambient_ += color;
        return;
    }
    const glm::vec3 shines = unitOr(-glm::vec3(nodeTransform[2]), {0.0f, 0.0f, -1.0f});
    const bool directional = light.kind == LightKind::Directional;
    const bool spot = light.kind == LightKind::Spot;
    texels_.emplace_back(directional ? glm::vec4(-shines, 0.0f)
                                     : glm::vec4(glm::vec3(nodeTransform[3]), 1.0f));
    texels_.emplace_back(shines, spot ? coneCosine(light) : kNoCone);
    texels_.emplace_back(color, spot ? light.falloffExponent : 0.0f);
    texels_.emplace_back(light.constantAttenuation, light.linearAttenuation / metersPerUnit,
                         light.quadraticAttenuation / (metersPerUnit * metersPerUnit), 0.0f);
}

}  // namespace walkcycle
