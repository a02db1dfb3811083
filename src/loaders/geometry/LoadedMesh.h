#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "walkcycle/model/MeshData.h"

namespace walkcycle {

inline constexpr std::uint32_t kNoCorner = ~std::uint32_t{0};

// A mesh, and what the loaders of morphs and skins need to know of it beside what is drawn.
struct LoadedMesh {
    MeshData mesh;
    // Per position, if <vertices> itself has a NORMAL input; otherwise empty.
    std::vector<glm::vec3> positionNormals;
    // The polygons of the file before they are cut into triangles.
    MeshFaces faces;
    // Per corner of `faces`: its vertex, or kNoVertex if it was left out. A morph target with the same
    // corners as its base finds the vertex of each corner here.
    std::vector<std::uint32_t> cornerVertices;
    bool hasNormals = false;  // whether the file has normals; if not, they are computed
    // Only if the file has no normals: per index of the mesh the corner of `faces`, kNoCorner for lines.
    std::vector<std::uint32_t> indexCorners;
};

}  // namespace walkcycle
