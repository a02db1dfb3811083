#include "render/MeshBuffers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "model/Deformers.h"
#include "render/VertexInput.h"

namespace walkcycle {
namespace {

constexpr std::uint32_t kInputInfluences = 4;  // those that are vertex inputs

template <typename T>
std::span<const T> view(const std::vector<T>& data) {
    return data;
}

// Stores optional data only if there is one entry per vertex, because the driver reads an entry for every vertex.
template <typename T>
void storeIfWhole(Vbo& vbo, const std::vector<T>& data, std::size_t vertices) {
    if (data.size() == vertices) vbo.store(view(data));
}

// The position of each vertex.
std::vector<glm::vec3> expanded(const MeshData& mesh) {
    std::vector<glm::vec3> positions(mesh.vertexCount());
    for (std::size_t v = 0; v < positions.size(); ++v) positions[v] = mesh.positions[mesh.vertexPositions[v]];
    return positions;
}

void appendDeltas(std::vector<glm::vec4>& texels, const std::vector<glm::vec3>& deltas, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        texels.push_back(i < deltas.size() ? glm::vec4(deltas[i], 0.0f) : glm::vec4(0.0f));
    }
}

// Calls `visit(target)` for each target of the instance's leading morphs, in the order of morphCoefficients.
template <typename Visit>
void forEachTarget(const Model& model, const MeshInstance& instance, Visit visit) {
    for (const Deformer& deformer : instance.deformers) {
        if (deformer.kind != Deformer::Kind::Morph) return;
        for (const MorphTarget& target : model.morphs[static_cast<std::size_t>(deformer.index)].targets)
            visit(target);
    }
}

const MeshData& meshOf(const Model& model, const MeshInstance& instance) {
    return model.meshes[static_cast<std::size_t>(instance.mesh)];
}

}  // namespace

MeshBuffers::MeshBuffers(const MeshData& mesh) {
    const std::size_t vertices = mesh.vertexCount();
    positions.store(view(expanded(mesh)));
    storeIfWhole(normals, mesh.normals, vertices);
    storeIfWhole(colors, mesh.colors, vertices);
    storeIfWhole(tangents, mesh.tangents, vertices);
    for (const TexCoordSet& set : mesh.texCoordSets) {
        texCoordSets.emplace_back();
        storeIfWhole(texCoordSets.back(), set.coords, vertices);
    }
    glBindVertexArray(0);  // otherwise storing the indices would change the bound vertex array
    indices.store(view(mesh.indices));
}

void MeshBuffers::feed(Vao& vao) const {
    vao.indices(indices);
    vao.floats(VertexInput::kPosition, positions, 3);
    if (!normals.empty()) vao.floats(VertexInput::kNormal, normals, 3);
    if (!colors.empty()) vao.floats(VertexInput::kColor, colors, 4);
    if (!tangents.empty()) vao.floats(VertexInput::kTangent, tangents, 4);
}

InfluenceBuffers::InfluenceBuffers(const Influences& influences, const MeshData& mesh) {
    struct Range {
        std::uint32_t first, last;
    };
    std::vector<std::array<std::uint32_t, 4>> jointIds(mesh.vertexCount(), {0, 0, 0, 0});
    std::vector<std::array<float, 4>> jointWeights(mesh.vertexCount(), {0.0f, 0.0f, 0.0f, 0.0f});
    std::vector<Range> ranges(mesh.vertexCount(), {0, 0});

    // Influences beyond the fourth are stored once per position, even if several vertices share it.
    std::vector<Range> ofPosition(mesh.positions.size(), {0, 0});
    std::vector<std::array<std::uint32_t, 2>> beyond;
    for (std::size_t p = 0; p < ofPosition.size(); ++p) {
        ofPosition[p].first = static_cast<std::uint32_t>(beyond.size());
        for (std::uint32_t i = influences.first[p] + kInputInfluences; i < influences.first[p + 1]; ++i) {
            const Influence& influence = influences.influences[i];
            beyond.push_back({influence.joint, std::bit_cast<std::uint32_t>(influence.weight)});
        }
        ofPosition[p].last = static_cast<std::uint32_t>(beyond.size());
    }
    std::uint32_t most = 1;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        const std::uint32_t p = mesh.vertexPositions[v], first = influences.first[p];
        const std::uint32_t here = std::min(influences.first[p + 1] - first, kInputInfluences);
        most = std::max(most, here);
        for (std::uint32_t i = 0; i < here; ++i) {
            jointIds[v][i] = influences.influences[first + i].joint;
            jointWeights[v][i] = influences.influences[first + i].weight;
        }
        ranges[v] = ofPosition[p];
    }
    count = static_cast<int>(most);
    joints.store(view(jointIds));
    weights.store(view(jointWeights));
    if (beyond.empty()) return;
    moreRanges.store(view(ranges));
    more.emplace(GL_RG32UI);
    more->store(view(beyond));
}

void InfluenceBuffers::feed(Vao& vao) const {
    vao.unsignedInts(VertexInput::kJointIndices, joints, 4);
    vao.floats(VertexInput::kWeights, weights, 4);
    if (more) vao.unsignedInts(VertexInput::kMoreInfluences, moreRanges, 2);
}

std::size_t influencesBeyondFour(const Influences& influences) {
    std::size_t count = 0;
    for (std::size_t p = 0; p + 1 < influences.first.size(); ++p) {
        const std::uint32_t all = influences.first[p + 1] - influences.first[p];
        if (all > kInputInfluences) count += all - kInputInfluences;
    }
    return count;
}

MorphBuffers::MorphBuffers(const Model& model, const MeshInstance& instance) {
    const MeshData& mesh = meshOf(model, instance);
    positionIndices.store(view(mesh.vertexPositions));
    std::vector<glm::vec4> forPositions, forNormals;
    forEachTarget(model, instance, [&](const MorphTarget& target) {
        appendDeltas(forPositions, target.positionDeltas, mesh.positions.size());
        appendDeltas(forNormals, target.normalDeltas, mesh.vertexCount());
    });
    positionDeltas.store(view(forPositions));
    normalDeltas.store(view(forNormals));
}

void MorphBuffers::feed(Vao& vao) const {
    vao.unsignedInts(VertexInput::kPositionIndex, positionIndices, 1);
}

std::size_t morphTexels(const Model& model, const MeshInstance& instance) {
    std::size_t targets = 0;
    forEachTarget(model, instance, [&](const MorphTarget&) { ++targets; });
    const MeshData& mesh = meshOf(model, instance);
    return targets * std::max(mesh.positions.size(), mesh.vertexCount());
}

void DeformedBuffers::feed(Vao& vao) const {
    vao.floats(VertexInput::kPosition, positions, 3);
    vao.floats(VertexInput::kNormal, normals, 3);
}

}  // namespace walkcycle
