#include "loaders/controllers/ControllerLoader.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "loaders/controllers/MorphDeltas.h"
#include "loaders/sources/Inputs.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {
namespace {

XmlNode skinOrMorph(XmlNode controller) {
    const XmlNode skin = controller.child("skin");
    return skin ? skin : controller.child("morph");
}

}  // namespace

XmlNode ControllerLoader::followToGeometry(XmlNode from, XmlNode controller, std::vector<XmlNode>& chain) {
    XmlNode element = controller;
    while (element.is("controller")) {
        if (std::find(chain.begin(), chain.end(), element) != chain.end()) {
            context_.diagnostics.report(Code::ReferenceLoop, element,
                                        {"controller", std::string(element.id())});
            return {};
        }
        chain.push_back(element);
        const XmlNode deformer = skinOrMorph(element);
        if (!deformer) {
            context_.diagnostics.report(Code::ControllerEmpty, element, {std::string(element.id())});
            return {};
        }
        from = deformer;
        element = context_.documents.follow(deformer, "source", {});
    }
    if (element && !element.is("geometry")) {
        context_.diagnostics.report(
            Code::WrongElement, from,
            {std::string(from.name()), std::string(element.id()), std::string(element.name()), "geometry"});
        return {};
    }
    return element;
}

XmlNode ControllerLoader::load(const SceneGraph::Instance& source, MeshInstance& instance) {
    const XmlNode controller = context_.documents.follow(source.element, "url", {});
    if (controller.is("geometry"))  // wrong, but clear: it is shown without deformers
        context_.diagnostics.report(
            Code::WrongElement, source.element,
            {"instance_controller", std::string(source.element.attribute("url")), "geometry", "controller"});
    std::vector<XmlNode> chain;
    const XmlNode geometry = followToGeometry(source.element, controller, chain);
    if (!geometry) return {};
    for (auto it = chain.rbegin(); it != chain.rend(); ++it) {
        Deformer deformer;
        if (it->child("skin")) {
            deformer.kind = Deformer::Kind::Skin;
            if (skin(*it, geometry, source, deformer)) instance.deformers.push_back(deformer);
        } else {
            deformer.kind = Deformer::Kind::Morph;
            deformer.index = morph(*it, geometry);
            instance.deformers.push_back(deformer);
        }
    }
    return geometry;
}

bool ControllerLoader::skin(XmlNode controller, XmlNode geometry, const SceneGraph::Instance& source,
                            Deformer& deformer) {
    auto& [usable, data] = skins_[controller];
    if (!data.skin) {
        meshes_.countPositions(meshes_.load(geometry).mesh.positions.size(), controller);
        usable = loadSkin(controller.child("skin"), meshes_.load(geometry).mesh.positions.size(), context_,
                          model_, data);
    }
    if (!usable) return false;
    boundJoints_ += data.jointNames.size() + 1;
    context_.require(boundJoints_, &LoadLimits::maxSkinJoints, source.element);
    deformer.index = static_cast<int>(model_.skins.size());
    deformer.influences = data.influences;
    model_.skins.push_back(bindSkin(data, source, joints_, skeletons_.scene(), context_));
    return true;
}

int ControllerLoader::morph(XmlNode controller, XmlNode geometry) {
    const auto [known, isNew] =
        targets_.morphs.try_emplace(controller, static_cast<int>(model_.morphs.size()));
    const int index = known->second;
    if (!isNew) return index;
    const XmlNode element = controller.child("morph");
    MorphTargets result;
    result.id = controller.id();
    const std::string_view method = element.attribute("method");
    result.method = method == "RELATIVE" ? MorphMethod::Relative : MorphMethod::Normalized;
    if (!method.empty() && method != "RELATIVE" && method != "NORMALIZED")
        context_.diagnostics.report(
            Code::WordUnknown, element,
            {std::string(method), "morph", didYouMean(method, "RELATIVE NORMALIZED")});
    result.firstParameter = static_cast<int>(model_.parameters.size());
    std::vector<float> weights;
    readTargets(element, geometry, result, weights);
    for (std::size_t t = 0; t < result.targets.size(); ++t)
        model_.parameters.push_back({ParameterKind::MorphWeight, index, static_cast<int>(t), weights[t]});
    model_.morphs.push_back(std::move(result));
    return index;
}

// A target is a <geometry>, or a controller, which stands for its geometry. Nothing for other elements.
XmlNode ControllerLoader::targetGeometry(XmlNode element) {
    if (!element.is("controller")) return element.is("geometry") ? element : XmlNode();
    std::vector<XmlNode> chain;
    return followToGeometry(element, element, chain);
}

void ControllerLoader::readTargets(XmlNode morph, XmlNode geometry, MorphTargets& result,
                                   std::vector<float>& weights) {
    const XmlNode targets = morph.child("targets");
    if (!targets) context_.diagnostics.report(Code::MissingElement, morph, {"morph", "targets"});
    std::shared_ptr<const NameSource> names;
    for (const Input& input : readInputs(targets, context_.documents, context_.diagnostics)) {
        bool isIdref = false;
        if (input.semantic == "MORPH_TARGET" && input.source)
            names = context_.sources.names(input.source, isIdref);
        if (input.semantic != "MORPH_WEIGHT" || !input.source) continue;
        if (const auto source = context_.sources.floats(input.source, NumberFaults::Error))
            weights = source->values;
        const int index = static_cast<int>(model_.morphs.size());
        targets_.morphs.emplace(input.source, index);
        for (XmlNode array : input.source.children("float_array")) targets_.morphs.emplace(array, index);
    }
    const std::size_t count = names ? names->values.size() : 0;
    if (count != weights.size())
        context_.diagnostics.report(
            Code::MorphTargetsMismatch, targets ? targets : morph,
            {std::to_string(count), std::to_string(weights.size()), std::to_string(count)});
    weights.resize(count);
    if (names) addTargets(*names, geometry, result);
}

void ControllerLoader::addTargets(const NameSource& names, XmlNode geometry, MorphTargets& result) {
    static const LoadedMesh kNothing;  // a target that is missing moves nothing
    const LoadedMesh& base = meshes_.load(geometry);
    const std::size_t wanted = base.mesh.positions.size();
    int missing = 0;
    for (std::size_t t = 0; t < names.values.size(); ++t) {
        const std::string& name = names.values[t];
        const XmlNode target = targetGeometry(context_.documents.resolve(names.element, "#" + name));
        if (!target)
            context_.diagnostics.report(Code::UnresolvedReference, names.array,
                                        {std::string(names.array.name()), name},
                                        ++missing <= kMostLinesLookedFor ? names.lineOf(t) : 0);
        meshes_.countPositions(wanted, names.array);
        const LoadedMesh& shape = target ? meshes_.load(target) : kNothing;
        if (target && shape.mesh.positions.size() < wanted)
            context_.diagnostics.report(Code::MorphTargetShort, target,
                                        {name, std::to_string(shape.mesh.positions.size()),
                                         std::string(geometry.id()), std::to_string(wanted)});
        result.targets.push_back(makeMorphDeltas(base, shape, result.method, name));
    }
}

}  // namespace walkcycle
