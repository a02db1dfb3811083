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

// Reads the controller of an <instance_controller>: skins and morphs on top of each other, in any order and
// number, down to the geometry that they deform (COLLADA 1.4.1, chapter 5, <controller>).
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

    // Returns the geometry that the controllers deform, and fills instance.deformers, innermost first.
    // Returns nothing, and reports it, if there is no geometry.
    XmlNode load(const SceneGraph::Instance& source, MeshInstance& instance);

private:
    // Fills `chain` with the controllers, outermost first, and returns their geometry. `from` is the element
    // that refers to the outermost one, for messages.
    XmlNode followToGeometry(XmlNode from, XmlNode controller, std::vector<XmlNode>& chain);
    int morph(XmlNode controller, XmlNode geometry);  // returns an index into Model::morphs
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
    std::unordered_map<XmlNode, std::pair<bool, SkinData>> skins_;  // by <controller>: usable?, contents
    std::uint64_t boundJoints_ = 0;
};

}  // namespace walkcycle
