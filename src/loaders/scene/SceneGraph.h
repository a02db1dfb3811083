#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "loaders/document/XmlNode.h"
#include "loaders/scene/TransformStack.h"
#include "walkcycle/animation/Joint.h"

namespace walkcycle {

// What SkeletonLoader makes of a <visual_scene>: one entry per occurrence of a <node>, in the order of
// Skeleton::joints. A <node> that is instanced twice has two occurrences.
struct SceneGraph {
    Skeleton skeleton;
    std::vector<XmlNode> nodes;          // per joint: its <node>
    std::vector<TransformStack> stacks;  // per joint
    std::vector<glm::dmat4>
        outer;  // per joint: what stands before its stack (an <asset>'s conversion); mostly identity
    std::vector<bool> drawn;  // false for joints of library_nodes that only a skin uses
    std::unordered_multimap<XmlNode, int> occurrences;  // <node> -> joints

    struct Instance {
        int node = 0;     // index into skeleton.joints
        XmlNode element;  // <instance_geometry>, <instance_controller>, <instance_camera>, <instance_light>
    };
    std::vector<Instance> geometries, controllers, cameras, lights;  // in document order
};

}  // namespace walkcycle
