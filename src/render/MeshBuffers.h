#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "model/Influences.h"
#include "model/MeshData.h"
#include "model/Model.h"
#include "render/BufferTexture.h"
#include "render/Vao.h"
#include "render/Vbo.h"

namespace walkcycle {

// A mesh on the GPU: one entry per drawn vertex in each buffer. Shared by all instances of the mesh.
struct MeshBuffers {
    explicit MeshBuffers(const MeshData& mesh);

    void feed(Vao& vao) const;  // everything but texture coordinates

    Vbo positions, normals, colors, tangents;
    std::vector<Vbo> texCoordSets;
    Vbo indices{GL_ELEMENT_ARRAY_BUFFER};
};

// The influences of a mesh's vertices: four as vertex inputs, those beyond in a texture buffer.
struct InfluenceBuffers {
    InfluenceBuffers(const Influences& influences, const MeshData& mesh);

    void feed(Vao& vao) const;

    int count = 1;  // the most that one of the vertices has of its four
    Vbo joints, weights, moreRanges;
    std::optional<BufferTexture> more;  // none where no vertex has more than four
};

// How many entries InfluenceBuffers::more would have: on drivers with small texture buffers it may not fit.
std::size_t influencesBeyondFour(const Influences& influences);

// What a stack of morphs adds to a mesh: target after target.
struct MorphBuffers {
    MorphBuffers(const Model& model, const MeshInstance& instance);

    void feed(Vao& vao) const;

    Vbo positionIndices;
    BufferTexture positionDeltas{GL_RGBA32F}, normalDeltas{GL_RGBA32F};
};

// How many texels the larger of MorphBuffers' textures would have.
std::size_t morphTexels(const Model& model, const MeshInstance& instance);

// Positions and normals that CpuSkinning writes anew for each picture.
struct DeformedBuffers {
    void feed(Vao& vao) const;

    Vbo positions, normals;
};

}  // namespace walkcycle
