#pragma once

#include <vector>

#include "loaders/LoadContext.h"
#include "model/MeshData.h"

namespace walkcycle {

// What morphs and skins need to know of a mesh beside what is drawn.
struct LoadedMesh {
    MeshData mesh;
    std::vector<glm::vec3> positionNormals;  // per position, where <vertices> itself has a NORMAL input; else empty
    // The corners in file order, before joining (triangulated): which vertex each became. A morph target with the same
    // corners finds its normals by this.
    std::vector<std::uint32_t> cornerVertices;
    std::vector<glm::vec3> cornerNormals;  // the file's own, per corner; empty where it has none
};

// Reads a <geometry>: all its primitives, triangulated, corners joined into vertices, missing normals made.
// Reports faults and gives what can be drawn, possibly a mesh without parts (a morph target may have no primitives).
LoadedMesh loadGeometry(XmlNode geometry, const LoadContext& context);

}  // namespace walkcycle
