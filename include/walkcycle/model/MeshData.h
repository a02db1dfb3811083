#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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

enum class Primitive { Triangles, Lines };

// A run of indices that share one material: one <triangles>, <polylist>, ... of the file.
struct MeshPart {
    Primitive primitive = Primitive::Triangles;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::string materialSymbol;  // what bind_material calls it
};

struct TexCoordSet {
    int set = 0;  // the `set` of the <input>, 0 where it has none
    std::vector<glm::vec2>
        coords;  // one per vertex; (0, 0) is the picture's lower left corner, as in COLLADA
};

// A <geometry> as plain data, in the file's own axes and unit. It has two kinds of points. `positions` are
// the entries of the file's POSITION source, to which morphs and skins refer. Vertices are drawn: each is a
// position with one normal, one texture coordinate per set and one colour. vertexPositions[v] is the position
// of vertex v.
struct MeshData {
    std::string id, name;
    std::vector<glm::vec3> positions;
    std::vector<bool> positionUsed;  // per position: a surface primitive (not a line) uses it

    std::vector<std::uint32_t> vertexPositions;  // per vertex: index into positions
    std::vector<glm::vec3> normals;              // per vertex, of unit length; zero for the vertices of lines
    std::vector<TexCoordSet> texCoordSets;
    std::vector<glm::vec4> colors;  // per vertex, linear as in the file; empty where the file has none
    std::vector<glm::vec4>
        tangents;  // per vertex, w is the bitangent's sign; empty unless a bump texture needs them

    std::vector<std::uint32_t> indices;  // into the vertices: three per triangle, two per line
    std::vector<MeshPart> parts;
    bool doubleSided = false;  // the file's hint
    MadeNormals madeNormals;   // only if the file has no normals and the mesh has deformers

    std::size_t vertexCount() const { return vertexPositions.size(); }
};

}  // namespace walkcycle
