#include "loaders/controllers/MorphDeltas.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

// For a target with the polygons of the base: corner by corner.
std::vector<glm::vec3> normalDeltasByCorner(const LoadedMesh& base, const LoadedMesh& target) {
    std::vector<glm::vec3> deltas(base.mesh.vertexCount(), glm::vec3(0.0f));
    for (std::size_t c = 0; c < base.cornerVertices.size(); ++c) {
        const std::uint32_t vertex = base.cornerVertices[c], its = target.cornerVertices[c];
        if (vertex != kNoVertex && its != kNoVertex)
            deltas[vertex] = target.mesh.normals[its] - base.mesh.normals[vertex];
    }
    return deltas;
}

bool hasSameCorners(const LoadedMesh& base, const LoadedMesh& target) {
    return target.cornerVertices.size() == base.cornerVertices.size() &&
           target.faces.cornerPositions == base.faces.cornerPositions;
}

// For a target with normals in <vertices>: position by position.
std::vector<glm::vec3> normalDeltasByPosition(const LoadedMesh& base, const LoadedMesh& target) {
    std::vector<glm::vec3> deltas(base.mesh.vertexCount(), glm::vec3(0.0f));
    for (std::size_t v = 0; v < deltas.size(); ++v) {
        const std::uint32_t position = base.mesh.vertexPositions[v];
        const bool known =
            position < target.positionNormals.size() && base.mesh.normals[v] != glm::vec3(0.0f);
        if (known) deltas[v] = target.positionNormals[position] - base.mesh.normals[v];
    }
    return deltas;
}

// For a target whose normals do not fit: computes normals for the polygons of the base twice, with the
// positions of the base and with the moved ones, and takes the difference.
std::vector<glm::vec3> normalDeltasByShape(const LoadedMesh& base,
                                           const std::vector<glm::vec3>& positionDeltas) {
    std::vector<glm::vec3> deformed = base.mesh.positions;
    for (std::size_t i = 0; i < deformed.size(); ++i) deformed[i] += positionDeltas[i];
    const std::vector<glm::vec3> before = smoothNormals(base.faces, base.mesh.positions, base.mesh.positions);
    const std::vector<glm::vec3> after = smoothNormals(base.faces, base.mesh.positions, deformed);
    std::vector<glm::vec3> deltas(base.mesh.vertexCount(), glm::vec3(0.0f));
    for (std::size_t c = 0; c < base.cornerVertices.size(); ++c) {
        const std::uint32_t vertex = base.cornerVertices[c];
        if (vertex != kNoVertex) deltas[vertex] = after[c] - before[c];
    }
    return deltas;
}

// Clamped, because the difference of two large floats may overflow.
glm::vec3 difference(const glm::vec3& to, const glm::vec3& from) {
    constexpr float kMost = std::numeric_limits<float>::max();
    return glm::clamp(to - from, -kMost, kMost);
}

}  // namespace

MorphTarget makeMorphDeltas(const LoadedMesh& base, const LoadedMesh& target, MorphMethod method,
                            std::string id) {
    MorphTarget result;
    result.id = std::move(id);
    const std::vector<glm::vec3>& from = base.mesh.positions;
    const std::vector<glm::vec3>& to = target.mesh.positions;
    result.positionDeltas.assign(from.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i)
        result.positionDeltas[i] = method == MorphMethod::Normalized ? difference(to[i], from[i]) : to[i];

    if (!base.hasNormals) return result;  // normals are computed after all deformers (MadeNormals)

    // A RELATIVE target may hold normals or differences of normals, so its normals are not used.
    const bool own = method == MorphMethod::Normalized && target.mesh.positions.size() >= from.size();
    if (own && target.hasNormals && hasSameCorners(base, target))
        result.normalDeltas = normalDeltasByCorner(base, target);
    else if (own && !target.positionNormals.empty())
        result.normalDeltas = normalDeltasByPosition(base, target);
    else
        result.normalDeltas = normalDeltasByShape(base, result.positionDeltas);
    return result;
}

}  // namespace walkcycle
