#include "loaders/materials/Tangents.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

// The directions in which u and v grow, or sums of such directions.
struct Frame {
    glm::dvec3 tangent{0.0};
    glm::dvec3 bitangent{0.0};
};

// The directions in which u and v grow on a triangle; zero if the triangle has no area in the picture.
Frame frameOf(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec2, 3>& uv) {
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const glm::dvec2 d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
    const double area = d1.x * d2.y - d2.x * d1.y;
    const double sign = area > 0.0 ? 1.0 : area < 0.0 ? -1.0 : 0.0;
    return {glm::dvec3(unitOrZero((e1 * d2.y - e2 * d1.y) * sign)),
            glm::dvec3(unitOrZero((e2 * d1.x - e1 * d2.x) * sign))};
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

void addTriangle(const MeshData& mesh, const std::vector<glm::vec2>& coords, const std::uint32_t* triangle,
                 std::vector<Frame>& frames) {
    std::array<glm::dvec3, 3> p;
    std::array<glm::dvec2, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = glm::dvec3(mesh.positions[mesh.vertexPositions[triangle[k]]]);
        uv[k] = glm::dvec2(coords[triangle[k]]);
    }
    const Frame frame = frameOf(p, uv);
    for (std::size_t k = 0; k < 3; ++k) {
        const double angle = angleBetween(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
        frames[triangle[k]].tangent += angle * frame.tangent;
        frames[triangle[k]].bitangent += angle * frame.bitangent;
    }
}

glm::vec4 tangentOf(const Frame& frame, const glm::vec3& vertexNormal) {
    const glm::dvec3 normal(vertexNormal);
    glm::vec3 tangent = unitOrZero(frame.tangent - normal * glm::dot(normal, frame.tangent));
    if (tangent == glm::vec3(0.0f)) {
        const glm::dvec3 any =
            std::abs(normal.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        tangent = unitOrZero(any - normal * glm::dot(normal, any));
    }
    const double side = glm::dot(glm::cross(normal, glm::dvec3(tangent)), frame.bitangent);
    return {tangent, side < 0.0 ? -1.0f : 1.0f};
}

}  // namespace

void makeTangents(MeshData& mesh, std::size_t set) {
    std::vector<Frame> frames(mesh.vertexCount());
    for (const MeshPart& part : mesh.parts) {
        if (part.primitive != Primitive::Triangles) continue;
        for (std::uint32_t i = part.firstIndex; i + 2 < part.firstIndex + part.indexCount; i += 3)
            addTriangle(mesh, mesh.texCoordSets[set].coords, mesh.indices.data() + i, frames);
    }
    mesh.tangents.resize(mesh.vertexCount());
    for (std::size_t v = 0; v < frames.size(); ++v) mesh.tangents[v] = tangentOf(frames[v], mesh.normals[v]);
}

}  // namespace walkcycle
