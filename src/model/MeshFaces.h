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

// Which corners meet: those of group g are corners[starts[g]] to corners[starts[g + 1]].
struct CornerGroups {
    std::vector<std::uint32_t> starts, corners;
};

// What normals are made of anew for each shape that a mesh takes, where its file has none. Each corner has a vertex of
// its own: which of them look the same is not known before the shape is.
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
