#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace walkcycle {

// One closed line of corners: a polygon, or a hole in the polygon before it.
struct Ring {
    std::uint32_t firstCorner = 0;
    std::uint32_t cornerCount = 0;
    bool hole = false;
};

// The polygons of a mesh as its file has them. A corner is one mention of a position by one polygon.
struct MeshFaces {
    std::vector<Ring> rings;
    std::vector<std::uint32_t> cornerPositions;  // per corner: index into the positions, or kNoPosition
};

inline constexpr std::uint32_t kNoPosition = ~std::uint32_t{0};
inline constexpr std::uint32_t kNoVertex = ~std::uint32_t{0};

// Groups of corners that meet at one place: group g is corners[starts[g]] up to, not including,
// corners[starts[g + 1]].
struct CornerGroups {
    std::vector<std::uint32_t> starts, corners;
};

// For a mesh without normals: from this they are computed for each shape that the mesh takes. Each corner has
// a vertex of its own, because which corners share a normal depends on the shape.
struct MadeNormals {
    MeshFaces faces;
    std::vector<std::uint32_t> cornerVertices;  // per corner: the vertex, or kNoVertex
    CornerGroups meetings;
};

// The rings of one polygon: [first, end) in MeshFaces::rings, the holes after their outline.
inline std::size_t endOfFace(const std::vector<Ring>& rings, std::size_t first) {
    std::size_t end = first + 1;
    while (end < rings.size() && rings[end].hole) ++end;
    return end;
}

}  // namespace walkcycle
