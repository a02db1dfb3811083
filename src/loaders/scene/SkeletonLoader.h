#pragma once

#include <cstdint>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Makes the Skeleton: a joint for every <node> of the scene, parents first, with <instance_node>s resolved.
// (The SkeletonLoader of the series reads only the nodes that are joints. But channels may animate any node,
// and any node may carry a skin.)
class SkeletonLoader {
public:
    // `asset` is the root document's. All nodes are converted to its unit and axes.
    SkeletonLoader(const LoadContext& context, const Asset& asset, XmlNode rootCollada)
        : context_(context), asset_(asset), rootCollada_(rootCollada) {}

    void addScene(XmlNode visualScene);

    // Adds a <node> that no scene shows, with the nodes below it, as a root that is not drawn: the joints of
    // a skin may be in <library_nodes> only. Returns its joint.
    int addUndrawn(XmlNode node);

    SceneGraph& scene() { return scene_; }

private:
    struct Visit {
        XmlNode node;
        int parent;
        XmlNode around;  // the parent <node>, or <COLLADA>: its <asset> gives the space of the parent
        bool instanced = false;
        std::uint64_t depth = 1;  // 1 for a root
    };
    void add(const Visit& root, bool drawn);
    int addJoint(const Visit& visit, bool drawn);
    bool reachesWorld(const Joint& joint);
    void addInstances(XmlNode node, int joint);
    std::vector<Visit> childrenOf(const Visit& visit, int joint);
    void countInstanced(XmlNode node);
    bool isInside(XmlNode node, int joint) const;

    const LoadContext& context_;
    const Asset& asset_;
    XmlNode rootCollada_;
    SceneGraph scene_;
    std::uint64_t instancedElements_ = 0, nodeText_ = 0;
    std::vector<glm::dmat4> worlds_;  // per joint: its model transform at rest
};

}  // namespace walkcycle
