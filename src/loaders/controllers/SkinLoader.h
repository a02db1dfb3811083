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

// What a <skin> says by itself, shared by all its instances: names, matrices, weights.
struct SkinData {
    XmlNode skin;
    std::vector<std::string> jointNames;
    std::shared_ptr<const NameSource> nameSource;  // where they stand; for messages
    bool namesAreIds = false;
    std::vector<glm::mat4> inverseBindMatrices;  // empty where the file has none
    glm::mat4 bindShapeMatrix{1.0f};
    int influences = -1;  // index into Model::influences
};

// Reads a <skin> for a mesh of so many positions; nothing usable (reported): false.
bool loadSkin(XmlNode skin, std::size_t positionCount, const LoadContext& context, Model& model,
              SkinData& data);

// Binds it: which occurrences of which nodes are its joints when it hangs on `node`.
Skin bindSkin(const SkinData& data, const SceneGraph::Instance& instance, JointFinder& joints,
              SceneGraph& scene, const LoadContext& context);

}  // namespace walkcycle
