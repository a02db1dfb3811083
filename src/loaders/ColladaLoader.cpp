#include "walkcycle/loaders/ColladaLoader.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <tinyxml2.h>

#include "loaders/Inspection.h"
#include "loaders/context/AssetReader.h"
#include "loaders/controllers/ControllerLoader.h"
#include "loaders/curves/AnimationLoader.h"
#include "loaders/document/KnownElements.h"
#include "loaders/document/LoadProgress.h"
#include "loaders/keys/AnimationFitter.h"
#include "loaders/materials/MaterialLoader.h"
#include "loaders/quirks/Dialect.h"
#include "loaders/scene/AnimationTargets.h"
#include "loaders/scene/SceneLoader.h"

namespace walkcycle {
namespace {

void checkVersion(XmlNode collada, const LoadContext& context) {
    const std::string version(collada.attribute("version"));
    if (version.rfind("1.3", 0) == 0 || version.rfind("1.2", 0) == 0 || version.rfind("1.1", 0) == 0)
        context.diagnostics.fail(Code::Version13, collada, {version});
    if (version.rfind("1.4", 0) != 0 && version.rfind("1.5", 0) != 0)
        context.diagnostics.report(Code::UnknownVersion, collada, {version});
}

// Only reports: the schema address does not change how the document is read.
void checkNamespace(XmlNode collada, const LoadContext& context) {
    const std::string qualified = collada.element()->Name();
    const std::size_t colon = qualified.find(':');
    const std::string attribute =
        colon == std::string::npos ? "xmlns" : "xmlns:" + qualified.substr(0, colon);
    const std::string_view schema = collada.attribute(attribute.c_str());
    if (schema.empty() || schema == "http://www.collada.org/2005/11/COLLADASchema" ||
        schema == "http://www.collada.org/2008/03/COLLADASchema")
        return;
    context.diagnostics.report(Code::WrongNamespace, collada, {std::string(schema)});
}

// One drawn mesh: an <instance_geometry>, or an <instance_controller> with the mesh beneath its deformers.
class InstanceLoader {
public:
    InstanceLoader(const LoadContext& context, MeshLibrary& meshes, ControllerLoader& controllers,
                   MaterialLoader& materials, Model& model)
        : context_(context),
          meshes_(meshes),
          controllers_(controllers),
          materials_(materials),
          model_(model) {}

    void add(const SceneGraph::Instance& source) {
        MeshInstance instance;
        instance.node = source.node;
        instance.sourceUrl = source.element.attribute("url");
        const XmlNode geometry = source.element.is("instance_controller")
                                     ? controllers_.load(source, instance)
                                     : context_.documents.follow(source.element, "url", "geometry");
        if (!geometry) return;
        if (!instance.deformers.empty()) meshes_.willDeform(geometry);
        const MeshData& mesh = meshes_.load(geometry).mesh;
        vertices_ += mesh.vertexCount();
        parts_ += std::max<std::size_t>(1, mesh.parts.size());
        context_.require(vertices_, &LoadLimits::maxVertices, source.element);
        context_.require(parts_, &LoadLimits::maxInstances, source.element);
        instance.mesh = meshes_.drawn(geometry);
        instance.materials = materials_.bind(source.element, mesh);
        model_.instances.push_back(std::move(instance));
    }

private:
    const LoadContext& context_;
    MeshLibrary& meshes_;
    ControllerLoader& controllers_;
    MaterialLoader& materials_;
    Model& model_;
    std::uint64_t vertices_ = 0, parts_ = 0;
};

// Loads meshes, skins, morphs and materials. Frees their sources before the key frames take memory.
void loadInstances(XmlNode collada, SkeletonLoader& skeletons, MaterialLoader& materials,
                   const LoadContext& context, Model& model, AnimationTargets& targets) {
    MeshLibrary meshes(context, model.asset, collada);
    ControllerLoader controllers(context, meshes, skeletons, model, targets);
    InstanceLoader instances(context, meshes, controllers, materials, model);
    const SceneGraph& scene = skeletons.scene();
    context.progress->begin(LoadProgress::Stage::Meshes);
    for (const SceneGraph::Instance& source : scene.geometries) instances.add(source);
    for (const SceneGraph::Instance& source : scene.controllers) instances.add(source);
    meshes.moveInto(model);
    makeBumpTangents(model);
    targets.materials = materials.elements();
    context.sources.forgetFloats();
}

// Loads the document's libraries, each after those that it depends on.
void loadModel(XmlNode collada, const LoadContext& context, Model& model) {
    MaterialLoader materials(context, model);
    materials.decodeAhead(collada);
    checkVersion(collada, context);
    checkNamespace(collada, context);
    checkElements(collada, context.diagnostics);
    model.asset = readAsset(collada, context);
    if (context.options.convert)
        model.skeleton.rootTransform = glm::mat4(toMetresYUp(model.asset.metersPerUnit, model.asset.upAxis));

    context.progress->begin(LoadProgress::Stage::Scene);
    const XmlNode visualScene = findVisualScene(collada, context);
    model.sceneId = visualScene.id();
    SkeletonLoader skeletons(context, model.asset, collada);
    skeletons.addScene(visualScene);

    AnimationTargets targets;
    loadInstances(collada, skeletons, materials, context, model, targets);

    SceneGraph& scene = skeletons.scene();
    loadCameras(scene, context, model, targets);
    loadLights(scene, context, model, targets);
    model.skeleton.joints = scene.skeleton.joints;
    loadVisibility(scene, context, model);
    for (Skin& skin : model.skins) skin.placedInRoot = model.skeleton.rootTransform;
    const LoadedMotion motion = loadAnimations(collada, scene, targets, context, model);
    fitAnimations(motion, collada, context, model);
    if (context.options.inspector) context.options.inspector({collada, scene, model, context});
}

template <typename Open>
Model load(const std::string& file, const LoadOptions& options, Open open) {
    requireValid(options);
    Diagnostics diagnostics(options.limits.maxMessages);
    LoadProgress progress(options, diagnostics, file);
    DocumentSet documents(options, diagnostics, &progress);
    Dialects dialects(options, diagnostics);
    const PieceRead numbersRead = [&](std::size_t characters) {
        progress.advance(static_cast<double>(characters));
    };
    SourceReader sources(documents, diagnostics, dialects, numbersRead);
    const LoadContext context{options, diagnostics, documents, sources, dialects, &progress};
    Model model;
    model.file = file;
    const XmlNode collada = open(documents).root();
    progress.plan(collada);
    progress.documentIs(1.0);
    loadModel(collada, context, model);
    model.diagnostics = diagnostics.take();
    progress.finish();
    return model;
}

}  // namespace

Model loadCollada(const std::string& path, const LoadOptions& options) {
    return load(path, options,
                [&](DocumentSet& set) -> const ColladaDocument& { return set.openFile(path); });
}

Model loadCollada(std::span<const std::uint8_t> bytes, const std::string& name, const LoadOptions& options) {
    return load(name, options,
                [&](DocumentSet& set) -> const ColladaDocument& { return set.openMemory(bytes, name); });
}

}  // namespace walkcycle
