#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace walkcycle {

// How targets are blended (COLLADA 1.4.1, chapter 5, <morph>). Normalized: (1 - sum of w) * base + sum of w *
// target. Relative: base + sum of w * target.
enum class MorphMethod { Normalized, Relative };

// A target, stored as the differences that it adds to the base mesh at weight 1. (For NORMALIZED, these are
// target - base.)
struct MorphTarget {
    std::string id;
    std::vector<glm::vec3> positionDeltas;  // one per MeshData::positions
    std::vector<glm::vec3> normalDeltas;  // one per vertex; empty if the base mesh has no normals in the file
};

// The targets of a <controller> with a <morph>, and the parameters that are their weights.
struct MorphTargets {
    std::string id;
    MorphMethod method = MorphMethod::Normalized;
    std::vector<MorphTarget> targets;
    int firstParameter = 0;  // the weight of target t is parameters[firstParameter + t]
};

}  // namespace walkcycle
