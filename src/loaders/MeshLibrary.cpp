#include "loaders/MeshLibrary.h"

#include <glm/gtc/matrix_inverse.hpp>

#include "loaders/AssetReader.h"

namespace walkcycle {
namespace {

// An <asset> on the geometry speaks another unit or another up axis than the document.
void convert(LoadedMesh& loaded, const glm::mat4& matrix) {
    const glm::mat3 turn(matrix);
    const auto turned = [&](const glm::vec3& normal) {
        const glm::vec3 result = turn * normal;
        const float length = glm::length(result);
        return length > 0.0f ? result / length : result;
    };
    for (glm::vec3& position : loaded.mesh.positions) position = glm::vec3(matrix * glm::vec4(position, 1.0f));
    for (glm::vec3& normal : loaded.mesh.normals) normal = turned(normal);
    for (glm::vec3& normal : loaded.positionNormals) normal = turned(normal);
}

}  // namespace

const LoadedMesh& MeshLibrary::load(XmlNode geometry) {
    std::unique_ptr<LoadedMesh>& slot = meshes_[geometry];
    if (slot) return *slot;
    context_.checkCancelled(geometry);
    slot = std::make_unique<LoadedMesh>(loadGeometry(geometry, context_));
    const glm::dmat4 conversion = assetConversion(geometry, rootCollada_, asset_, rootCollada_);
    if (conversion != glm::dmat4(1.0)) convert(*slot, glm::mat4(conversion));
    return *slot;
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
