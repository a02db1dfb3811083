#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace walkcycle {

// COLLADA 1.4.1, <morph method>: NORMALIZED is (1 - sum of w) * base + sum of w * target; RELATIVE is
// base + sum of w * target.
enum class MorphMethod { Normalized, Relative };

// A shape to blend to, stored as what it adds to the base mesh at weight 1 (for NORMALIZED: target - base).
struct MorphTarget {
    std::string id;
    std::vector<glm::vec3> positionDeltas;  // one per MeshData::positions
    std::vector<glm::vec3> normalDeltas;    // one per vertex; empty where the target has no fitting normals
};

// A <controller><morph>: its targets, and which parameters are their weights.
struct MorphTargets {
    std::string id;
    MorphMethod method = MorphMethod::Normalized;
    std::vector<MorphTarget> targets;
    int firstParameter = 0;  // weight of target t is parameters[firstParameter + t]
};

}  // namespace walkcycle
