#include "loaders/curves/ParameterFinder.h"

#include <array>
#include <cstddef>
#include <utility>

#include "loaders/quirks/Dialect.h"

namespace walkcycle {

namespace {

// The index of a name in a list; -1 if it is not in it.
template <std::size_t N>
int indexIn(const std::array<std::string_view, N>& names, std::string_view name) {
    for (std::size_t i = 0; i < N; ++i)
        if (names[i] == name) return static_cast<int>(i);
    return -1;
}

// In the order of CameraComponent, LightComponent, Slot and MaterialComponent.
constexpr std::array<std::string_view, 7> kCameraElements{"xfov",         "yfov",  "xmag", "ymag",
                                                          "aspect_ratio", "znear", "zfar"};
constexpr std::array<std::string_view, 6> kLightElements{"intensity",          "constant_attenuation",
                                                         "linear_attenuation", "quadratic_attenuation",
                                                         "falloff_angle",      "falloff_exponent"};
constexpr std::array<std::string_view, kSlotCount> kSlotElements{
    "emission", "ambient", "diffuse", "specular", "reflective", "transparent", "bump"};
constexpr std::array<std::string_view, 4> kMaterialElements{"shininess", "reflectivity", "transparency",
                                                            "index_of_refraction"};

// The value at rest of a component, as in CameraComponent, LightComponent and MaterialComponent.
float restOf(const SceneCamera& camera, int component) {
    const std::array<double, 7> values{camera.xfov.value_or(0.0),
                                       camera.yfov.value_or(0.0),
                                       camera.xmag.value_or(0.0),
                                       camera.ymag.value_or(0.0),
                                       camera.aspect.value_or(0.0),
                                       camera.znear,
                                       camera.zfar};
    return static_cast<float>(values[static_cast<std::size_t>(component)]);
}

float restOf(const SceneLight& light, int component) {
    const std::array<float, 6> values{light.intensity,         light.constantAttenuation,
                                      light.linearAttenuation, light.quadraticAttenuation,
                                      light.falloffAngle,      light.falloffExponent};
    return values[static_cast<std::size_t>(component)];
}

float restOf(const Material& material, int component) {
    const std::array<float, 4> values{material.shininess, material.reflectivity, material.transparency,
                                      material.indexOfRefraction};
    return values[static_cast<std::size_t>(component)];
}

// The <param> elements with this `ref` below an element. The number of elements is limited, because each
// channel searches its effect.
std::vector<XmlNode> paramsNamed(XmlNode from, std::string_view ref) {
    constexpr int kMostElements = 10'000;
    std::vector<XmlNode> found;
    int looked = 0;
    for (XmlNode element : from.descendants()) {
        if (++looked > kMostElements) break;
        if (element.is("param") && element.attribute("ref") == ref) found.push_back(element);
    }
    return found;
}

}  // namespace

ParameterFinder::ParameterFinder(const SceneGraph& scene, const AnimationTargets& targets,
                                 const LoadContext& context, Model& model)
    : scene_(scene), targets_(targets), context_(context), model_(model) {}

int ParameterFinder::parameter(ParameterKind kind, int object, int component, float restValue) {
    const auto [known, isNew] =
        known_.try_emplace({kind, object, component}, static_cast<int>(model_.parameters.size()));
    if (isNew) model_.parameters.push_back({kind, object, component, restValue});
    return known->second;
}

std::vector<std::vector<int>> ParameterFinder::find(const ChannelTarget& target) {
    if (auto weights = morphWeights(target); !weights.empty()) return weights;
    const XmlNode element = target.element;
    if (enclosing(element, "camera")) return cameraValue(element);
    if (enclosing(element, "light")) return lightValue(element);
    if (const XmlNode effect = enclosing(element, "effect")) return materialValue(element, effect);
    if (const XmlNode material = enclosing(element, "material")) return materialValue(element, material);
    return visibility(element);
}

// The target names the array of the weights, its <source>, or the <controller>.
std::vector<std::vector<int>> ParameterFinder::morphWeights(const ChannelTarget& target) {
    auto morph = targets_.morphs.end();
    const XmlNode named = target.element ? target.element : target.root;
    for (XmlNode node = named; node && morph == targets_.morphs.end(); node = node.parent())
        morph = targets_.morphs.find(node);
    if (morph == targets_.morphs.end()) return {};
    if (!target.element) {
        if (!context_.dialects.follows(Quirk::MorphWeightsByController, named)) return {};
        context_.dialects.note(Quirk::MorphWeightsByController, named);
    }
    const MorphTargets& morphTargets = model_.morphs[static_cast<std::size_t>(morph->second)];
    std::vector<int> weights;
    for (std::size_t i = 0; i < morphTargets.targets.size(); ++i)
        weights.push_back(morphTargets.firstParameter + static_cast<int>(i));
    return {std::move(weights)};
}

std::vector<std::vector<int>> ParameterFinder::cameraValue(XmlNode element) {
    const auto camera = targets_.cameras.find(enclosing(element, "camera"));
    const int component = indexIn(kCameraElements, element.name());
    if (camera == targets_.cameras.end() || component < 0) return {};
    const SceneCamera& values = model_.cameras[static_cast<std::size_t>(camera->second)];
    return {{parameter(ParameterKind::CameraValue, camera->second, component, restOf(values, component))}};
}

std::vector<std::vector<int>> ParameterFinder::lightValue(XmlNode element) {
    const auto found = targets_.lights.find(enclosing(element, "light"));
    if (found == targets_.lights.end()) return {};
    const SceneLight& light = model_.lights[static_cast<std::size_t>(found->second)];
    if (element.is("color")) {
        std::vector<int> channels;
        for (int c = 0; c < 3; ++c)
            channels.push_back(parameter(ParameterKind::LightColor, found->second, c, light.color[c]));
        return {std::move(channels)};
    }
    const int component = indexIn(kLightElements, element.name());
    if (component < 0) return {};
    return {{parameter(ParameterKind::LightValue, found->second, component, restOf(light, component))}};
}

std::vector<std::vector<int>> ParameterFinder::visibility(XmlNode element) {
    std::vector<std::vector<int>> found;
    const XmlNode node = enclosing(element, "node");
    if (!element.is("visibility") || !node) return found;
    if (!context_.dialects.follows(Quirk::ExtraVisibility, element)) return found;
    const auto [first, last] = scene_.occurrences.equal_range(node);
    for (auto joint = first; joint != last; ++joint) {
        const bool visible = model_.nodeVisible[static_cast<std::size_t>(joint->second)];
        found.push_back({parameter(ParameterKind::NodeVisible, joint->second, 0, visible ? 1.0f : 0.0f)});
    }
    return found;
}

// The target is the number itself, in its slot; or a <newparam> or <setparam>, to which slots refer by name.
std::vector<std::vector<int>> ParameterFinder::materialValue(XmlNode element, XmlNode owner) {
    std::vector<std::vector<int>> found;
    XmlNode named = enclosing(element, "newparam");
    if (!named) named = enclosing(element, "setparam");
    if (!named) {
        addSlot(owner, indexIn(kSlotElements, element.name()) >= 0 ? element.name() : element.parent().name(),
                found);
        return found;
    }
    const std::string_view ref = named.is("newparam") ? named.sid() : named.attribute("ref");
    XmlNode effect = owner;
    if (owner.is("material")) {
        const XmlNode instance = owner.child("instance_effect");
        effect = context_.documents.resolve(instance, instance.attribute("url"));
    }
    for (XmlNode param : paramsNamed(effect, ref)) addSlot(owner, param.parent().name(), found);
    return found;
}

void ParameterFinder::addSlot(XmlNode owner, std::string_view slotName,
                              std::vector<std::vector<int>>& found) {
    const int slot = indexIn(kSlotElements, slotName);
    const int value = indexIn(kMaterialElements, slotName);
    const auto [first, last] = targets_.materials.equal_range(owner);
    for (auto entry = first; entry != last; ++entry) {
        const Material& material = model_.materials[static_cast<std::size_t>(entry->second)];
        std::vector<int> numbers;
        for (int c = 0; slot >= 0 && c < 4; ++c)
            numbers.push_back(parameter(ParameterKind::MaterialColor, entry->second, slot * 4 + c,
                                        material.slots[static_cast<std::size_t>(slot)].color[c]));
        if (value >= 0)
            numbers.push_back(
                parameter(ParameterKind::MaterialValue, entry->second, value, restOf(material, value)));
        if (!numbers.empty()) found.push_back(std::move(numbers));
    }
}

}  // namespace walkcycle
