#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>

#include "walkcycle/model/Influences.h"
#include "walkcycle/model/MeshData.h"

namespace walkcycle {
namespace {

std::span<const Influence> ofPosition(const Influences& all, std::uint32_t position) {
    return std::span(all.influences)
        .subspan(all.first[position], all.first[position + 1] - all.first[position]);
}

void addVertex(std::vector<Influence>& sorted, LimitedInfluences& out) {
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    const std::size_t kept = std::min(sorted.size(), out.perVertex);
    if (kept < sorted.size()) {
        ++out.cutVertices;
        out.largestDropped = std::max(out.largestDropped, sorted[kept].weight);
    }
    float sum = 0.0f;
    for (std::size_t i = 0; i < kept; ++i) sum += sorted[i].weight;
    for (std::size_t i = 0; i < out.perVertex; ++i) {
        out.joints.push_back(i < kept ? sorted[i].joint : 0);
        out.weights.push_back(i < kept && sum > 0.0f ? sorted[i].weight / sum : 0.0f);
    }
}

}  // namespace

LimitedInfluences limitInfluences(const Influences& influences, const MeshData& mesh, std::size_t most) {
    if (most == 0) throw std::invalid_argument("limitInfluences: a vertex needs at least one influence");
    if (influences.first.size() != mesh.positions.size() + 1)
        throw std::invalid_argument("limitInfluences: the influences are not those of this mesh");
    LimitedInfluences out;
    out.perVertex = most;
    out.joints.reserve(mesh.vertexCount() * most);
    out.weights.reserve(mesh.vertexCount() * most);
    std::vector<Influence> sorted;
    for (const std::uint32_t position : mesh.vertexPositions) {
        const std::span<const Influence> all = ofPosition(influences, position);
        sorted.assign(all.begin(), all.end());
        addVertex(sorted, out);
    }
    return out;
}

float limitingError(const LimitedInfluences& limited, const Influences& influences, const MeshData& mesh,
                    std::span<const glm::mat4> palette) {
    assert(limited.weights.size() == mesh.vertexCount() * limited.perVertex);
    float farthest = 0.0f;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        const glm::vec4 position(mesh.positions[mesh.vertexPositions[v]], 1.0f);
        glm::vec4 all(0.0f), kept(0.0f);
        for (const Influence& influence : ofPosition(influences, mesh.vertexPositions[v]))
            all += influence.weight * (palette[influence.joint] * position);
        for (std::size_t i = v * limited.perVertex; i < (v + 1) * limited.perVertex; ++i)
            kept += limited.weights[i] * (palette[limited.joints[i]] * position);
        farthest = std::max(farthest, glm::distance(glm::vec3(all), glm::vec3(kept)));
    }
    return farthest;
}

}  // namespace walkcycle
