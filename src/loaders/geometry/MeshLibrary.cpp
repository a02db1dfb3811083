#include "loaders/geometry/MeshLibrary.h"

#include <utility>

#include <glm/gtc/matrix_inverse.hpp>

#include "loaders/context/AssetReader.h"
#include "loaders/geometry/GeometryLoader.h"
#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

// Converts a geometry whose own <asset> has another unit or up axis than the root document.
void convert(LoadedMesh& loaded, const glm::mat4& matrix) {
    const glm::mat3 linear(matrix);
    const auto converted = [&](const glm::vec3& normal) {
        const glm::vec3 result = linear * normal;
        const float length = glm::length(result);
        return length > 0.0f ? result / length : result;
    };
    for (glm::vec3& position : loaded.mesh.positions)
        position = glm::vec3(matrix * glm::vec4(position, 1.0f));
    for (glm::vec3& normal : loaded.mesh.normals) normal = converted(normal);
    for (glm::vec3& normal : loaded.positionNormals) normal = converted(normal);
}

// Appends a copy of an entry; attributes that the mesh does not have stay empty.
template <typename T>
void repeatEntry(std::vector<T>& entries, std::size_t entry) {
    if (entry < entries.size()) entries.push_back(T(entries[entry]));
}

std::uint32_t repeatVertex(MeshData& mesh, std::uint32_t vertex) {
    const std::size_t repeated = mesh.vertexCount();
    repeatEntry(mesh.vertexPositions, vertex);
    repeatEntry(mesh.normals, vertex);
    for (TexCoordSet& set : mesh.texCoordSets) repeatEntry(set.coords, vertex);
    repeatEntry(mesh.colors, vertex);
    return static_cast<std::uint32_t>(repeated);
}

// Gives each corner a vertex of its own, as MadeNormals needs it.
void separateCorners(LoadedMesh& loaded) {
    std::vector<bool> taken(loaded.mesh.vertexCount(), false);
    for (std::uint32_t& vertex : loaded.cornerVertices) {
        if (vertex == kNoVertex) continue;
        if (taken[vertex])
            vertex = repeatVertex(loaded.mesh, vertex);
        else
            taken[vertex] = true;
    }
    for (std::size_t i = 0; i < loaded.indexCorners.size(); ++i) {
        const std::uint32_t corner = loaded.indexCorners[i];
        if (corner != kNoCorner) loaded.mesh.indices[i] = loaded.cornerVertices[corner];
    }
}

}  // namespace

const LoadedMesh& MeshLibrary::load(XmlNode geometry) {
    std::unique_ptr<LoadedMesh>& slot = meshes_[geometry];
    if (slot) return *slot;
    context_.checkCancelled(geometry);
    slot = std::make_unique<LoadedMesh>(loadGeometry(geometry, context_));
    countPositions(slot->mesh.positions.size(), geometry);
    const glm::dmat4 conversion = assetConversion(geometry, rootCollada_, asset_, rootCollada_);
    if (conversion != glm::dmat4(1.0)) convert(*slot, glm::mat4(conversion));
    return *slot;
}

void MeshLibrary::countPositions(std::size_t count, XmlNode where) {
    positions_ += count;
    context_.require(positions_, &LoadLimits::maxPositions, where);
}

void MeshLibrary::willDeform(XmlNode geometry) {
    load(geometry);
    LoadedMesh& loaded = *meshes_[geometry];
    MadeNormals& made = loaded.mesh.madeNormals;
    if (loaded.hasNormals || !made.faces.rings.empty()) return;
    separateCorners(loaded);
    made = {loaded.faces, loaded.cornerVertices, groupCorners(loaded.faces, loaded.mesh.positions)};
}

int MeshLibrary::drawn(XmlNode geometry) {
    load(geometry);
    const auto [entry, isNew] = indices_.try_emplace(geometry, static_cast<int>(drawn_.size()));
    if (isNew) drawn_.push_back(meshes_[geometry].get());
    return entry->second;
}

void MeshLibrary::moveInto(Model& model) {
    for (LoadedMesh* loaded : drawn_) model.meshes.push_back(std::move(loaded->mesh));
}

}  // namespace walkcycle
