#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "render/BufferTexture.h"
#include "render/Vao.h"
#include "render/Vbo.h"
#include "walkcycle/model/Influences.h"
#include "walkcycle/model/MeshData.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// A mesh on the GPU: one entry per vertex in each buffer. Shared by all instances of the mesh.
struct MeshBuffers {
    explicit MeshBuffers(const MeshData& mesh);

    // Connects the buffers to the vertex shader's inputs, except texture coordinates, whose set depends on the
    // material.
    void feed(Vao& vao) const;

    Vbo positions, normals, colors, tangents;
    std::vector<Vbo> texCoordSets;
    Vbo indices{GL_ELEMENT_ARRAY_BUFFER};
};

// The influences of a mesh's vertices: the first four of each vertex as vertex inputs, the others in a texture buffer.
struct InfluenceBuffers {
    InfluenceBuffers(const Influences& influences, const MeshData& mesh);

    void feed(Vao& vao) const;

    int count = 1;                      // the most influences of a vertex, up to four
    Vbo joints, weights;                // four per vertex; 0 if there are fewer
    Vbo moreRanges;                     // per vertex: [first, end) in `more`
    std::optional<BufferTexture> more;  // empty if no vertex has more than four
};

// The number of entries that InfluenceBuffers::more would have. On a device with small texture buffers, they may not
// fit into one.
std::size_t influencesBeyondFour(const Influences& influences);

// The deltas of an instance's leading morphs, target after target: one texel per position and target, and one per
// vertex and target.
struct MorphBuffers {
    MorphBuffers(const Model& model, const MeshInstance& instance);

    void feed(Vao& vao) const;

    Vbo positionIndices;  // MeshData::vertexPositions
    BufferTexture positionDeltas{GL_RGBA32F}, normalDeltas{GL_RGBA32F};
};

// The number of texels in the larger of MorphBuffers' textures.
std::size_t morphTexels(const Model& model, const MeshInstance& instance);

// Positions and normals that CpuSkinning computes for each picture.
struct DeformedBuffers {
    void feed(Vao& vao) const;

    Vbo positions, normals;
};

}  // namespace walkcycle
