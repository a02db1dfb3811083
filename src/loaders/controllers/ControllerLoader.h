#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/controllers/JointFinder.h"
#include "loaders/controllers/SkinLoader.h"
#include "loaders/document/XmlNode.h"
#include "loaders/geometry/MeshLibrary.h"
#include "loaders/scene/AnimationTargets.h"
#include "loaders/scene/SkeletonLoader.h"

namespace walkcycle {

// Follows an <instance_controller> through its skins and morphs, in any order and number, to the mesh beneath them.
class ControllerLoader {
public:
    ControllerLoader(const LoadContext& context, MeshLibrary& meshes, SkeletonLoader& skeletons, Model& model,
                     AnimationTargets& targets)
        : context_(context),
          meshes_(meshes),
          joints_(context, skeletons),
          skeletons_(skeletons),
          model_(model),
          targets_(targets) {}

    // The geometry beneath the controller, and its deformers, innermost first; nothing (reported) where it leads nowhere.
    // Fills instance.deformers.
    XmlNode load(const SceneGraph::Instance& source, MeshInstance& instance);

private:
    // The controllers from the outermost to the one on the geometry. `from` refers to the outermost; for messages.
    XmlNode followToGeometry(XmlNode from, XmlNode controller, std::vector<XmlNode>& chain);
    int morph(XmlNode controller, XmlNode geometry);
    void readTargets(XmlNode morph, XmlNode geometry, MorphTargets& result, std::vector<float>& weights);
    void addTargets(const NameSource& names, XmlNode geometry, MorphTargets& result);
    XmlNode targetGeometry(XmlNode element);
    bool skin(XmlNode controller, XmlNode geometry, const SceneGraph::Instance& source, Deformer& deformer);

    const LoadContext& context_;
    MeshLibrary& meshes_;
    JointFinder joints_;
    SkeletonLoader& skeletons_;
    Model& model_;
    AnimationTargets& targets_;
    std::unordered_map<XmlNode, std::pair<bool, SkinData>> skins_;
    std::uint64_t boundJoints_ = 0;
};

}  // namespace walkcycle
