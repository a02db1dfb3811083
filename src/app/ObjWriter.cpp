#include "app/ObjWriter.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/FormatNumber.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

void line(std::string& text, const char* what, std::initializer_list<float> numbers) {
    text += what;
    for (const float number : numbers) text += ' ' + formatNumber(number);
    text += '\n';
}

std::string corner(std::size_t vertex, bool textured) {
    const std::string number = std::to_string(vertex);
    return number + "/" + (textured ? number : "") + "/" + number;
}

void faces(std::string& text, const MeshData& mesh, std::size_t firstVertex, bool textured) {
    for (const MeshPart& part : mesh.parts) {
        const bool triangles = part.primitive == Primitive::Triangles;
        if (!part.materialSymbol.empty()) text += "g " + part.materialSymbol + "\n";
        const std::uint32_t corners = triangles ? 3 : 2;
        for (std::uint32_t i = 0; i + corners <= part.indexCount; i += corners) {
            text += triangles ? "f" : "l";
            for (std::uint32_t c = 0; c < corners; ++c) {
                const std::size_t vertex = firstVertex + mesh.indices[part.firstIndex + i + c];
                text += ' ' + (triangles ? corner(vertex, textured) : std::to_string(vertex));
            }
            text += '\n';
        }
    }
}

}  // namespace

std::string poseObj(const Model& model, const Animator& animator) {
    std::string text = "# walkcycle pose\n";
    CpuSkinning skinning;
    std::vector<glm::vec3> positions, normals;
    std::size_t firstVertex = 1;  // OBJ numbers the vertices of all objects together, from 1
    for (const MeshInstance& instance : model.instances) {
        const MeshData& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
        skinning.vertices(model, instance, animator.modelTransforms(), animator.parameters(), positions,
                          normals);
        text += "o " + (mesh.name.empty() ? mesh.id : mesh.name) + "\n";
        for (const glm::vec3& p : positions) line(text, "v", {p.x, p.y, p.z});
        // Positions, texture coordinates and normals have the same indices here, so a mesh without texture
        // coordinates gets zeros.
        const bool textured = !mesh.texCoordSets.empty();
        for (std::size_t v = 0; v < positions.size(); ++v) {
            const glm::vec2 uv = textured ? mesh.texCoordSets.front().coords[v] : glm::vec2(0.0f);
            line(text, "vt", {uv.x, uv.y});
        }
        for (const glm::vec3& n : normals) line(text, "vn", {n.x, n.y, n.z});
        faces(text, mesh, firstVertex, textured);
        firstVertex += positions.size();
    }
    return text;
}

}  // namespace walkcycle
