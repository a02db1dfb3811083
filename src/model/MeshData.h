#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/MeshFaces.h"

namespace walkcycle {

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
