#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace walkcycle {

inline constexpr int kNoParent = -1;  // Joint::parent of a root

// One node of the scene's tree. COLLADA animates nodes, and joints are nodes, so every node is a Joint here.
struct Joint {
    std::string name;
    std::string id;          // unique in its document; empty if the file gives none
    std::string sid;         // the name that a skin's Name_array uses; at best unique among siblings
    int parent = kNoParent;  // index into Skeleton::joints, always smaller than the joint's own
    glm::mat4 localBindTransform{1.0f};  // at rest: joint space -> the parent's space
    bool isJoint = false;                // <node type="JOINT">
};

// All nodes of a scene. Parents come before their children, so that playing walks the array once, front to back.
struct Skeleton {
    std::vector<Joint> joints;
    // From the document's axes and unit to metres with Y up; the identity without LoadOptions::convert.
    glm::mat4 rootTransform{1.0f};
};

}  // namespace walkcycle
