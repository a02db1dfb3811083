#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "walkcycle/model/MeshData.h"

namespace walkcycle {

inline constexpr std::uint32_t kNoCorner = ~std::uint32_t{0};

// What morphs and skins need to know of a mesh beside what is drawn.
struct LoadedMesh {
    MeshData mesh;
    // Per position, where <vertices> itself has a NORMAL input; else empty.
    std::vector<glm::vec3> positionNormals;
    // The polygons as the file has them, before they are cut into triangles, and which vertex each of their corners
    // became (kNoVertex for those that are left out). A mesh with the same corners finds its own by this.
    MeshFaces faces;
    std::vector<std::uint32_t> cornerVertices;
    bool hasNormals = false;  // the normals are the file's own
    // Per index of the mesh, if it has no normals: the corner, kNoCorner for lines.
    std::vector<std::uint32_t> indexCorners;
};

}  // namespace walkcycle
