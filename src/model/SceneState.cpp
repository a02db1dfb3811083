#include "walkcycle/model/SceneState.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace walkcycle {
namespace {

void apply(SceneCamera& camera, CameraComponent component, float value) {
    switch (component) {
        case CameraComponent::XFov:
            camera.xfov = value;
            break;
        case CameraComponent::YFov:
            camera.yfov = value;
            break;
        case CameraComponent::XMag:
            camera.xmag = value;
            break;
        case CameraComponent::YMag:
            camera.ymag = value;
            break;
        case CameraComponent::Aspect:
            camera.aspect = value;
            break;
        case CameraComponent::ZNear:
            camera.znear = value;
            break;
        case CameraComponent::ZFar:
            camera.zfar = value;
            break;
    }
}

void apply(SceneLight& light, LightComponent component, float value) {
    switch (component) {
        case LightComponent::Intensity:
            light.intensity = value;
            break;
        case LightComponent::ConstantAttenuation:
            light.constantAttenuation = value;
            break;
        case LightComponent::LinearAttenuation:
            light.linearAttenuation = value;
            break;
        case LightComponent::QuadraticAttenuation:
            light.quadraticAttenuation = value;
            break;
        case LightComponent::FalloffAngle:
            light.falloffAngle = value;
            break;
        case LightComponent::FalloffExponent:
            light.falloffExponent = value;
            break;
    }
}

// A material that is opaque at rest must be drawn with blending while an animation makes it transparent.
void blendIfFaded(Material& material) {
    const ColorOrTexture& transparent = material.slot(Slot::Transparent);
    if (opacity(material, transparent.color) < 1.0f) material.transparent = true;
}

void apply(Material& material, MaterialComponent component, float value) {
    switch (component) {
        case MaterialComponent::Shininess:
            material.shininess = value;
            break;
        case MaterialComponent::Reflectivity:
            material.reflectivity = value;
            break;
        case MaterialComponent::IndexOfRefraction:
            material.indexOfRefraction = value;
            break;
        case MaterialComponent::Transparency:
            material.transparency = value;
            blendIfFaded(material);
            break;
    }
}

void applyColor(Material& material, int component, float value) {
    const auto slot = static_cast<std::size_t>(component / 4);
    assert(slot < material.slots.size());
    material.slots[slot].color[component % 4] = value;
    if (slot == static_cast<std::size_t>(Slot::Transparent)) blendIfFaded(material);
}

}  // namespace

SceneState::SceneState(const Model& model)
    : materials(model.materials),
      cameras(model.cameras),
      lights(model.lights),
      nodeVisible(model.nodeVisible) {
    nodeVisible.resize(model.skeleton.joints.size(), true);
}

void SceneState::apply(const Model& model, std::span<const float> parameters) {
    const std::size_t count = std::min(model.parameters.size(), parameters.size());
    for (std::size_t i = 0; i < count; ++i) {
        const Parameter& parameter = model.parameters[i];
        const auto object = static_cast<std::size_t>(parameter.object);
        const float value = parameters[i];
        switch (parameter.kind) {
            case ParameterKind::MorphWeight:
                break;
            case ParameterKind::CameraValue:
                walkcycle::apply(cameras[object], static_cast<CameraComponent>(parameter.component), value);
                break;
            case ParameterKind::LightColor:
                lights[object].color[parameter.component] = value;
                break;
            case ParameterKind::LightValue:
                walkcycle::apply(lights[object], static_cast<LightComponent>(parameter.component), value);
                break;
            case ParameterKind::MaterialColor:
                applyColor(materials[object], parameter.component, value);
                break;
            case ParameterKind::MaterialValue:
                walkcycle::apply(materials[object], static_cast<MaterialComponent>(parameter.component),
                                 value);
                break;
            case ParameterKind::NodeVisible:
                nodeVisible[object] = value > 0.5f;
                break;
        }
    }
}

}  // namespace walkcycle
