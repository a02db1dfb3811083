#pragma once

#include <cstdint>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Makes the Skeleton: every <node> of the scene, parents first, <instance_node>s followed. (The series' SkeletonLoader
// reads the joint nodes alone; but animations move any node, and skins may hang on any.)
class SkeletonLoader {
public:
    // `asset` is the root document's, whose space the whole scene is brought to.
    SkeletonLoader(const LoadContext& context, const Asset& asset, XmlNode rootCollada)
        : context_(context), asset_(asset), rootCollada_(rootCollada) {}

    void addScene(XmlNode visualScene);

    // Adds a <node> that no scene shows, with all below it, as an extra root that is not drawn: the joints of a skin
    // may live in <library_nodes> alone. Gives its joint.
    int addUndrawn(XmlNode node);

    SceneGraph& scene() { return scene_; }

private:
    struct Visit {
        XmlNode node;
        int parent;
        XmlNode around;  // the element whose space the node's parent is in
        bool instanced = false;
        std::uint64_t depth = 1;  // levels of nodes, with this one
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
