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

// A target with the base's polygons has one corner for each of the base's.
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

// How made normals would turn when the base's polygons are laid through the target's positions.
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

// Finite, also where the distance is more than single precision can say.
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

    if (!base.hasNormals) return result;  // they are made of the shape that all deformers make together

    // The normals of a RELATIVE target are differences, if anything; what the shape does is clear.
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
