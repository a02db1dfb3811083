#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace walkcycle {

inline constexpr int kNoParent = -1;

// One node of the scene's tree. COLLADA animates nodes, and joints are nodes, so every node is a Joint here.
struct Joint {
    std::string name;
    std::string id;                      // unique in its document; empty where the file gives none
    std::string sid;                     // what a skin's Name_array calls it; unique among siblings at best
    int parent = kNoParent;              // index into Skeleton::joints, always smaller than the joint's own
    glm::mat4 localBindTransform{1.0f};  // relative to the parent, as the file has it at rest
    bool isJoint = false;                // <node type="JOINT">
};

// All nodes of a scene, parents before their children, so that playing walks the array once, front to back.
struct Skeleton {
    std::vector<Joint> joints;
    glm::mat4 rootTransform{
        1.0f};  // from the document's axes and unit to Y-up metres; identity if not converted
};

}  // namespace walkcycle
