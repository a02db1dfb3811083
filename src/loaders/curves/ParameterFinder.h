#pragma once

#include <map>
#include <string_view>
#include <tuple>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/curves/ChannelTarget.h"
#include "loaders/document/XmlNode.h"
#include "loaders/scene/AnimationTargets.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Finds the parameters of the model that the target of a channel means: morph weights, values of cameras and
// lights, colours and numbers of materials, visibility. Appends parameters that the model does not have yet.
class ParameterFinder {
public:
    ParameterFinder(const SceneGraph& scene, const AnimationTargets& targets, const LoadContext& context,
                    Model& model);

    // Returns one list per object that the target moves (one <effect> may have become several materials): the
    // parameter of each number of the element. Empty if the element is no parameter, or not shown.
    std::vector<std::vector<int>> find(const ChannelTarget& target);

private:
    std::vector<std::vector<int>> morphWeights(const ChannelTarget& target);
    std::vector<std::vector<int>> cameraValue(XmlNode element);
    std::vector<std::vector<int>> lightValue(XmlNode element);
    std::vector<std::vector<int>> visibility(XmlNode element);
    std::vector<std::vector<int>> materialValue(XmlNode element, XmlNode owner);
    void addSlot(XmlNode owner, std::string_view slotName, std::vector<std::vector<int>>& found);
    int parameter(ParameterKind kind, int object, int component, float restValue);

    const SceneGraph& scene_;
    const AnimationTargets& targets_;
    const LoadContext& context_;
    Model& model_;
    std::map<std::tuple<ParameterKind, int, int>, int> known_;
};

}  // namespace walkcycle
