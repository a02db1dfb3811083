#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/InfoText.h"
#include "app/JointKeys.h"
#include "app/ModelFacts.h"

namespace walkcycle {
namespace {

using Json = nlohmann::ordered_json;

Json meshes(const ModelFacts& facts) {
    Json list = Json::array();
    for (const MeshFacts& mesh : facts.meshes)
        list.push_back({{"id", mesh.name},
                        {"positions", mesh.positions},
                        {"vertices", mesh.vertices},
                        {"triangles", mesh.triangles},
                        {"lines", mesh.lines},
                        {"joints", mesh.joints},
                        {"maxInfluences", mesh.maxInfluences},
                        {"morphTargets", mesh.morphTargets},
                        {"instances", mesh.instances}});
    return list;
}

Json clips(const ModelFacts& facts) {
    Json list = Json::array();
    for (const ClipFacts& clip : facts.clips)
        list.push_back({{"name", clip.name},
                        {"start", clip.startSeconds},
                        {"end", clip.endSeconds},
                        {"movingNodes", clip.movingJoints},
                        {"movingValues", clip.movingParameters},
                        {"keys", clip.keys},
                        {"achievedError", clip.achievedError}});
    return list;
}

Json materials(const Model& model) {
    Json list = Json::array();
    for (const Material& material : model.materials) {
        Json entry = {{"id", material.id},
                      {"name", material.name},
                      {"shading", nameOf(material.shading)},
                      {"transparent", material.transparent},
                      {"doubleSided", material.doubleSided}};
        const int texture = material.slot(Slot::Diffuse).texture;
        if (texture >= 0) entry["diffuseTexture"] = model.textures[static_cast<std::size_t>(texture)].id;
        list.push_back(std::move(entry));
    }
    return list;
}

Json textures(const Model& model) {
    Json list = Json::array();
    for (const Texture& texture : model.textures) {
        Json entry = {{"id", texture.id},
                      {"uri", texture.uri},
                      {"found", !texture.path.empty()},
                      {"path", texture.path}};
        if (texture.image) entry["size"] = {texture.image->width, texture.image->height};
        list.push_back(std::move(entry));
    }
    return list;
}

Json cameras(const Model& model, const std::vector<std::string>& keys) {
    Json list = Json::array();
    for (const CameraInstance& instance : model.cameraInstances) {
        const SceneCamera& camera = model.cameras[static_cast<std::size_t>(instance.camera)];
        list.push_back({{"node", keys[static_cast<std::size_t>(instance.node)]},
                        {"id", camera.id},
                        {"name", camera.name},
                        {"orthographic", camera.orthographic}});
    }
    return list;
}

Json lights(const Model& model, const std::vector<std::string>& keys) {
    Json list = Json::array();
    for (const LightInstance& instance : model.lightInstances) {
        const SceneLight& light = model.lights[static_cast<std::size_t>(instance.light)];
        list.push_back({{"node", keys[static_cast<std::size_t>(instance.node)]},
                        {"id", light.id},
                        {"kind", nameOf(light.kind)}});
    }
    return list;
}

Json quirks(const Dialect& dialect) {
    Json list = Json::array();
    for (const QuirkInfo& quirk : kQuirks)
        list.push_back({{"name", quirk.name},
                        {"on", dialect.follows(quirk.quirk)},
                        {"why", dialect.why(quirk.quirk)},
                        {"used", dialect.isUsed(quirk.quirk)}});
    return list;
}

}  // namespace

std::string infoJson(const Model& model, const Dialect& dialect) {
    const ModelFacts facts = factsOf(model);
    const std::vector<std::string> keys = jointKeys(model.skeleton);
    Json joints = Json::array();
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (model.skeleton.joints[i].isJoint) joints.push_back(keys[i]);
    const Json json = {{"file", model.file},
                       {"version", model.asset.version},
                       {"authoringTool", model.asset.authoringTool},
                       {"dialect", exporterText(dialect.exporter())},
                       {"quirks", quirks(dialect)},
                       {"upAxis", nameOf(model.asset.upAxis)},
                       {"unit", {{"name", model.asset.unitName}, {"meters", model.asset.metersPerUnit}}},
                       {"scene", model.sceneId},
                       {"nodes", keys.size()},
                       {"joints", joints},
                       {"maxInfluences", facts.maxInfluences},
                       {"meshes", meshes(facts)},
                       {"clips", clips(facts)},
                       {"materials", materials(model)},
                       {"textures", textures(model)},
                       {"cameras", cameras(model, keys)},
                       {"lights", lights(model, keys)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace walkcycle
