#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "loaders/document/XmlNode.h"
#include "loaders/scene/TransformStack.h"
#include "walkcycle/animation/Joint.h"

namespace walkcycle {

// The nodes of a <visual_scene>, made by SkeletonLoader. Each vector has one entry per joint, in the order of
// Skeleton::joints. A <node> that is instanced twice becomes two joints, its occurrences.
struct SceneGraph {
    Skeleton skeleton;
    std::vector<XmlNode> nodes;          // per joint: its <node>
    std::vector<TransformStack> stacks;  // per joint
    // Per joint: the matrix left of its stack. It converts the unit and axes of an <asset> of the node's own
    // (or of another document) to those of its parent; nearly always the identity.
    std::vector<glm::dmat4> outer;
    std::vector<bool> drawn;  // per joint: false if only a skin refers to its node, in <library_nodes>
    std::unordered_multimap<XmlNode, int> occurrences;  // <node> -> joints

    struct Instance {
        int node = 0;     // index into skeleton.joints
        XmlNode element;  // <instance_geometry>, <instance_controller>, <instance_camera>, <instance_light>
    };
    std::vector<Instance> geometries, controllers, cameras, lights;  // in document order
};

}  // namespace walkcycle
