#pragma once

#include <vector>

#include "loaders/LoadContext.h"
#include "model/MeshData.h"
#include "model/MeshFaces.h"

namespace walkcycle {

// What morphs and skins need to know of a mesh beside what is drawn.
struct LoadedMesh {
    MeshData mesh;
    std::vector<glm::vec3>
        positionNormals;  // per position, where <vertices> itself has a NORMAL input; else empty
    // The polygons as the file has them, before they are cut into triangles, and which vertex each of their corners
    // became (kNoVertex for those that are left out). A mesh with the same corners finds its own by this.
    MeshFaces faces;
    std::vector<std::uint32_t> cornerVertices;
    bool hasNormals = false;  // the normals are the file's own
    std::vector<std::uint32_t>
        indexCorners;  // per index of the mesh, if it has no normals: the corner, kNoCorner for lines
};

inline constexpr std::uint32_t kNoCorner = ~std::uint32_t{0};

// Reads a <geometry>: all its primitives, triangulated, corners joined into vertices, missing normals made.
// Reports faults and gives what can be drawn, possibly a mesh without parts (a morph target may have no primitives).
LoadedMesh loadGeometry(XmlNode geometry, const LoadContext& context);

}  // namespace walkcycle
