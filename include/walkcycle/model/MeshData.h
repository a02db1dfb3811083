#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace walkcycle {

// A closed line of corners: a polygon, or a hole in the polygon before it.
struct Ring {
    std::uint32_t firstCorner = 0;  // index into MeshFaces::cornerPositions
    std::uint32_t cornerCount = 0;
    bool hole = false;
};

// The polygons of a mesh as in the file, before they are cut into triangles. A corner is one use of a
// position by one polygon.
struct MeshFaces {
    std::vector<Ring> rings;
    std::vector<std::uint32_t> cornerPositions;  // per corner: index into the positions, or kNoPosition
};

// Stand for an index out of range, and for the vertex of a corner that was left out.
inline constexpr std::uint32_t kNoPosition = ~std::uint32_t{0};
inline constexpr std::uint32_t kNoVertex = ~std::uint32_t{0};

// The corners of each position: those of group g are corners[starts[g]] to corners[starts[g + 1] - 1].
struct CornerGroups {
    std::vector<std::uint32_t> starts, corners;
};

// Only for meshes without normals in the file: the data from which normals are computed for each deformed
// shape. Each corner has a vertex of its own, because which corners share a normal depends on the shape.
struct MadeNormals {
    MeshFaces faces;
    std::vector<std::uint32_t> cornerVertices;  // per corner: the vertex, or kNoVertex
    CornerGroups meetings;                      // the corners that may share a normal
};

// The index after the last ring of the polygon whose outline is rings[first]; its holes follow the outline.
inline std::size_t endOfFace(const std::vector<Ring>& rings, std::size_t first) {
    std::size_t end = first + 1;
    while (end < rings.size() && rings[end].hole) ++end;
    return end;
}

// What a part consists of.
enum class Primitive { Triangles, Lines };

// A range of MeshData::indices with one material: one <triangles>, <polylist>, ... of the file.
struct MeshPart {
    Primitive primitive = Primitive::Triangles;
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    std::string materialSymbol;  // which <bind_material> maps to a material
};

// A set of texture coordinates.
struct TexCoordSet {
    int set = 0;  // the `set` of the <input>; a free number if the file has none or uses it twice
    // One per vertex. (0, 0) is the lower left corner of the picture, as in COLLADA.
    std::vector<glm::vec2> coords;
};

// A <geometry> (COLLADA 1.4.1, chapter 5), in the document's own axes and unit. It has two kinds of points.
// Positions are the entries of the POSITION source; morphs and skins refer to them. Vertices are drawn: a
// vertex is a position (vertexPositions) with a normal, one texture coordinate per set, and a colour.
struct MeshData {
    std::string id, name;
    std::vector<glm::vec3> positions;
    std::vector<bool> positionUsed;  // per position: whether a polygon (not only a line) uses it

    std::vector<std::uint32_t> vertexPositions;  // per vertex: index into positions
    std::vector<glm::vec3> normals;              // per vertex, of unit length; zero for the vertices of lines
    std::vector<TexCoordSet> texCoordSets;
    std::vector<glm::vec4> colors;  // per vertex, linear as in the file; empty if it has none
    // Per vertex: the unit direction in which u grows, and in w the sign of the bitangent, which is
    // cross(normal, tangent) * w. Empty unless the mesh has a bump texture.
    std::vector<glm::vec4> tangents;

    std::vector<std::uint32_t> indices;  // into the vertices: three per triangle, two per line
    std::vector<MeshPart> parts;
    bool doubleSided = false;  // draw back faces, too: the file says so in <extra>
    MadeNormals madeNormals;   // filled only if the file has no normals and a deformer uses the mesh

    std::size_t vertexCount() const { return vertexPositions.size(); }
};

}  // namespace walkcycle
