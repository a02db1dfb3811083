#include "loaders/scene/SceneLoader.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "loaders/quirks/Dialect.h"
#include "loaders/quirks/Extras.h"
#include "loaders/text/NumberParser.h"

namespace walkcycle {
namespace {

std::optional<double> number(XmlNode node, const LoadContext& context) {
    if (!node) return std::nullopt;
    double value = 0.0;
    const std::string text = node.text();
    if (parseNumber(text, value)) return value;
    context.diagnostics.report(Code::NumberOddWarning, node, {text, std::string(node.name()), "the default"});
    return std::nullopt;
}

// For angles, sizes and ratios, which must be positive.
std::optional<double> positive(XmlNode node, const LoadContext& context) {
    const std::optional<double> value = number(node, context);
    if (!value || *value > 0.0) return value;
    context.diagnostics.report(Code::NumberOddWarning, node,
                               {node.text(), std::string(node.name()), "the default"});
    return std::nullopt;
}

// Sets `value` if the element is there and holds a number.
template <typename T>
void read(XmlNode node, const LoadContext& context, T& value) {
    if (const auto parsed = number(node, context)) value = static_cast<T>(*parsed);
}

// The first element that exists, of a list from the inside to the outside. The last one must exist.
XmlNode innermost(std::initializer_list<XmlNode> elements) {
    return *std::find_if(elements.begin(), elements.end() - 1, [](XmlNode element) { return bool(element); });
}

SceneCamera readCamera(XmlNode camera, const LoadContext& context) {
    SceneCamera result;
    result.id = camera.id();
    result.name = camera.attribute("name");
    const XmlNode common = camera.child("optics").child("technique_common");
    const XmlNode perspective = common.child("perspective"), orthographic = common.child("orthographic");
    const XmlNode optics = perspective ? perspective : orthographic;
    result.orthographic = !perspective && orthographic;
    result.xfov = positive(optics.child("xfov"), context);
    result.yfov = positive(optics.child("yfov"), context);
    result.xmag = positive(optics.child("xmag"), context);
    result.ymag = positive(optics.child("ymag"), context);
    result.aspect = positive(optics.child("aspect_ratio"), context);
    read(optics.child("znear"), context, result.znear);
    read(optics.child("zfar"), context, result.zfar);
    const bool complete = result.orthographic ? result.xmag || result.ymag : result.xfov || result.yfov;
    if (!complete) {
        context.diagnostics.report(Code::OpticsMissing,
                                   innermost({optics, common, camera.child("optics"), camera}),
                                   {result.id, "45 degrees"});
        result.orthographic = false;
        result.yfov = 45.0;
    }
    return result;
}

bool readKind(XmlNode technique, LightKind& kind, XmlNode& element) {
    const std::pair<const char*, LightKind> kinds[] = {{"ambient", LightKind::Ambient},
                                                       {"directional", LightKind::Directional},
                                                       {"point", LightKind::Point},
                                                       {"spot", LightKind::Spot}};
    for (const auto& [name, value] : kinds) {
        element = technique.child(name);
        kind = value;
        if (element) return true;
    }
    return false;
}

// An <intensity> in <extra> is not read: exporters have multiplied <color> by it already.
std::optional<SceneLight> readLight(XmlNode light, const LoadContext& context) {
    SceneLight result;
    result.id = light.id();
    result.name = light.attribute("name");
    XmlNode element;
    if (!readKind(light.child("technique_common"), result.kind, element)) {
        context.diagnostics.report(Code::LightKindUnknown,
                                   innermost({light.child("technique_common"), light}), {result.id});
        return std::nullopt;
    }
    if (const XmlNode color = element.child("color")) {
        const std::vector<double> values = readDoubles(color, context.diagnostics, NumberFaults::Warning);
        if (values.size() != 3 && values.size() != 4)  // an alpha has no meaning, and is ignored
            context.diagnostics.report(Code::ColorNumbers, color, {"color", std::to_string(values.size())});
        for (std::size_t i = 0; i < std::min<std::size_t>(3, values.size()); ++i)
            result.color[static_cast<int>(i)] = static_cast<float>(values[i]);
    }
    read(element.child("constant_attenuation"), context, result.constantAttenuation);
    read(element.child("linear_attenuation"), context, result.linearAttenuation);
    read(element.child("quadratic_attenuation"), context, result.quadraticAttenuation);
    read(element.child("falloff_angle"), context, result.falloffAngle);
    read(element.child("falloff_exponent"), context, result.falloffExponent);
    return result;
}

XmlNode sceneNamed(XmlNode collada, const std::string& wanted, const LoadContext& context) {
    std::string known;
    for (XmlNode library : collada.children("library_visual_scenes")) {
        for (XmlNode scene : library.children("visual_scene")) {
            if (scene.id() == wanted || scene.attribute("name") == wanted) return scene;
            known += (known.empty() ? "" : ", ") + std::string(scene.id());
        }
    }
    context.diagnostics.fail(Code::SceneNotFound, collada, {wanted, known.empty() ? "none" : known});
}

}  // namespace

XmlNode findVisualScene(XmlNode collada, const LoadContext& context) {
    if (!context.options.scene.empty()) return sceneNamed(collada, context.options.scene, context);
    const XmlNode instance = collada.child("scene").child("instance_visual_scene");
    if (instance) {
        if (const XmlNode scene = context.documents.follow(instance, "url", "visual_scene")) return scene;
    }
    for (XmlNode library : collada.children("library_visual_scenes")) {
        const XmlNode first = library.child("visual_scene");
        if (!first) continue;
        if (!instance) context.diagnostics.report(Code::SceneGuessed, collada, {std::string(first.id())});
        return first;
    }
    context.diagnostics.fail(Code::NoScene, innermost({instance, collada.child("scene"), collada}), {});
}

void loadCameras(const SceneGraph& scene, const LoadContext& context, Model& model,
                 AnimationTargets& targets) {
    for (const SceneGraph::Instance& instance : scene.cameras) {
        const XmlNode camera = context.documents.follow(instance.element, "url", "camera");
        if (!camera) continue;
        const auto [known, isNew] =
            targets.cameras.try_emplace(camera, static_cast<int>(model.cameras.size()));
        if (isNew) model.cameras.push_back(readCamera(camera, context));
        model.cameraInstances.push_back({instance.node, known->second});
    }
}

void loadLights(const SceneGraph& scene, const LoadContext& context, Model& model,
                AnimationTargets& targets) {
    std::unordered_map<XmlNode, bool> unusable;  // <light>s that are reported already
    for (const SceneGraph::Instance& instance : scene.lights) {
        const XmlNode light = context.documents.follow(instance.element, "url", "light");
        if (!light || unusable.count(light)) continue;
        const auto [known, isNew] = targets.lights.try_emplace(light, static_cast<int>(model.lights.size()));
        if (isNew) {
            const std::optional<SceneLight> read = readLight(light, context);
            if (!read) {
                targets.lights.erase(known);
                unusable[light] = true;
                continue;
            }
            model.lights.push_back(*read);
        }
        model.lightInstances.push_back({instance.node, known->second});
    }
}

void loadVisibility(const SceneGraph& scene, const LoadContext& context, Model& model) {
    model.nodeVisible.assign(scene.nodes.size(), true);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (XmlNode technique : extraTechniques(scene.nodes[i])) {
            const XmlNode visibility = technique.child("visibility");
            if (!visibility || !context.dialects.follows(Quirk::ExtraVisibility, visibility)) continue;
            if (number(visibility, context).value_or(1.0) != 0.0) continue;
            model.nodeVisible[i] = false;
            context.dialects.note(Quirk::ExtraVisibility, visibility);
        }
}

}  // namespace walkcycle
