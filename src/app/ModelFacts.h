#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "walkcycle/model/Model.h"

namespace walkcycle {

// Counts and sizes of a model and its parts, for `info` and `check --json`.
struct MeshFacts {
    std::string name;
    std::size_t positions = 0, vertices = 0, triangles = 0, lines = 0;
    std::size_t joints = 0, maxInfluences = 0, morphTargets = 0;  // the most over all instances
    std::size_t instances = 0;
};

struct ClipFacts {
    std::string name;
    double startSeconds = 0.0, endSeconds = 0.0;
    std::size_t movingJoints = 0, movingParameters = 0, keys = 0;
    double achievedError = 0.0;
};

struct ModelFacts {
    std::vector<MeshFacts> meshes;
    std::vector<ClipFacts> clips;
    std::size_t joints = 0, maxInfluences = 0;
    std::size_t drawnVertices = 0, drawnTriangles = 0;  // summed over all instances
};

ModelFacts factsOf(const Model& model);

const char* nameOf(UpAxis axis);
const char* nameOf(ShadingModel shading);
const char* nameOf(LightKind kind);

}  // namespace walkcycle
