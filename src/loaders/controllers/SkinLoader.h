#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/controllers/JointFinder.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The contents of a <skin> (COLLADA 1.4.1, chapter 5), shared by all its instances.
struct SkinData {
    XmlNode skin;
    std::vector<std::string> jointNames;
    std::shared_ptr<const NameSource> nameSource;  // of jointNames; for messages
    bool namesAreIds = false;                      // of an IDREF_array; otherwise they are sids
    std::vector<glm::mat4> inverseBindMatrices;    // per joint name; empty if the file has none
    glm::mat4 bindShapeMatrix{1.0f};
    int influences = -1;  // index into Model::influences
};

// Reads a <skin> for a mesh with so many positions, and appends its weights to model.influences. Returns
// false, and reports why, if it cannot be used.
bool loadSkin(XmlNode skin, std::size_t positionCount, const LoadContext& context, Model& model,
              SkinData& data);

// Binds a skin to the joints of one instance: resolves each joint name to an occurrence of a <node>. A name
// without a joint is reported, and its vertices follow the node of the instance.
Skin bindSkin(const SkinData& data, const SceneGraph::Instance& instance, JointFinder& joints,
              SceneGraph& scene, const LoadContext& context);

}  // namespace walkcycle
