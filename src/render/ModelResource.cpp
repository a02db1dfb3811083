#include "render/ModelResource.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#include "model/Deformers.h"
#include "render/VertexInput.h"

namespace walkcycle {
namespace {

constexpr std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

bool hasPicture(const Model& model, int texture) {
    if (texture < 0 || index(texture) >= model.textures.size()) return false;
    const auto& image = model.textures[index(texture)].image;
    return image && image->width > 0 && image->height > 0;
}

TexelKind texelKind(Slot slot) {
    return slot == Slot::Bump ? TexelKind::Data : TexelKind::Color;
}

// Whether the part's pictures use more than one set of texture coordinates.
bool usesSeveralSets(const Model& model, const PartMaterial& part) {
    if (part.material < 0) return false;
    int set = -1;
    for (std::size_t s = 0; s < index(kSlotCount); ++s) {
        if (!hasPicture(model, model.materials[index(part.material)].slots[s].texture)) continue;
        if (set >= 0 && part.texCoordSets[s] != set) return true;
        set = part.texCoordSets[s];
    }
    return false;
}

// The part's sets, with -1 for slots that need none, so that parts with equal needs share a vertex array.
std::array<int, kSlotCount> neededSets(const Model& model, const PartMaterial& part, std::size_t setCount) {
    std::array<int, kSlotCount> sets;
    sets.fill(-1);
    if (part.material < 0) return sets;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const int set = part.texCoordSets[s];
        const bool needed = hasPicture(model, model.materials[index(part.material)].slots[s].texture);
        if (needed && set >= 0 && index(set) < setCount) sets[s] = set;
    }
    return sets;
}

// The number of morphs before the skin, or of all if there is no skin.
std::size_t leadingMorphs(const MeshInstance& instance) {
    const auto isSkin = [](const Deformer& deformer) { return deformer.kind == Deformer::Kind::Skin; };
    const auto skin = std::find_if(instance.deformers.begin(), instance.deformers.end(), isSkin);
    return static_cast<std::size_t>(skin - instance.deformers.begin());
}

// Whether the vertex shader can deform the instance on this device; otherwise CpuSkinning does.
bool fitsTheShader(const Model& model, const MeshInstance& instance, std::size_t maxTexels) {
    if (!shaderCanDeform(model, instance) || morphTexels(model, instance) > maxTexels) return false;
    for (const Deformer& deformer : instance.deformers) {
        if (deformer.kind != Deformer::Kind::Skin) continue;
        if (model.skins[index(deformer.index)].joints.size() > maxTexels / 3) return false;
        if (influencesBeyondFour(model.influences[index(deformer.influences)]) > maxTexels) return false;
    }
    return true;
}

// The position of the part that is nearest to the middle of its box.
std::uint32_t middlePosition(const MeshData& mesh, const MeshPart& part) {
    Bounds box;
    const auto position = [&](std::uint32_t i) {
        return mesh.vertexPositions[mesh.indices[part.firstIndex + i]];
    };
    for (std::uint32_t i = 0; i < part.indexCount; ++i) box.add(mesh.positions[position(i)]);
    std::uint32_t nearest = 0;
    float least = 1e30f;
    for (std::uint32_t i = 0; i < part.indexCount; ++i) {
        const float distance = glm::length(mesh.positions[position(i)] - box.center());
        if (distance >= least) continue;
        least = distance;
        nearest = position(i);
    }
    return nearest;
}

// boxesOfMatrices() of an instance that the shader deforms without morphs.
std::vector<Bounds> boxes(const Model& model, const MeshData& mesh, const ModelResource::Instance& resource) {
    if (resource.skin < 0) return boxesOfMatrices(mesh, nullptr, 1);
    return boxesOfMatrices(mesh, &model.influences[index(resource.influences)],
                           model.skins[index(resource.skin)].joints.size());
}

// Whether the material is transparent, or an animation may make it so.
bool mayBeTransparent(const Model& model, int material) {
    if (material < 0) return false;
    if (model.materials[index(material)].transparent) return true;
    return std::any_of(model.parameters.begin(), model.parameters.end(), [&](const Parameter& parameter) {
        return (parameter.kind == ParameterKind::MaterialColor ||
                parameter.kind == ParameterKind::MaterialValue) &&
               parameter.object == material;
    });
}

}  // namespace

ModelResource::ModelResource(const Model& model, std::size_t maxTexels) {
    addTextures(model);
    for (const MeshInstance& instance : model.instances) {
        for (const PartMaterial& part : instance.materials)
            needs_.separateCoords |= usesSeveralSets(model, part);
    }
    instances_.reserve(model.instances.size());
    for (const MeshInstance& instance : model.instances) addInstance(model, instance, maxTexels);
    glBindVertexArray(0);
}

const GlTexture* ModelResource::texture(int i, Slot slot) const {
    const auto& textures = texelKind(slot) == TexelKind::Data ? dataTextures_ : colorTextures_;
    return i >= 0 && index(i) < textures.size() && textures[index(i)] ? &*textures[index(i)] : nullptr;
}

void ModelResource::addTextures(const Model& model) {
    colorTextures_.resize(model.textures.size());
    dataTextures_.resize(model.textures.size());
    for (const Material& material : model.materials) {
        for (std::size_t s = 0; s < index(kSlotCount); ++s) {
            addTexture(model, material.slots[s].texture, static_cast<Slot>(s));
        }
    }
}

void ModelResource::addTexture(const Model& model, int i, Slot slot) {
    if (!hasPicture(model, i)) return;
    needs_.texturedSlots |= 1u << static_cast<unsigned>(slot);
    needs_.bumped |= slot == Slot::Bump;
    auto& texture = (texelKind(slot) == TexelKind::Data ? dataTextures_ : colorTextures_)[index(i)];
    if (!texture) texture.emplace(GlTexture(model.textures[index(i)], texelKind(slot)));
}

void ModelResource::addInstance(const Model& model, const MeshInstance& instance, std::size_t maxTexels) {
    Instance resource;
    const MeshData& mesh = model.meshes[index(instance.mesh)];
    if (!fitsTheShader(model, instance, maxTexels)) {
        resource.deformedOnCpu = true;
        resource.deformed = std::make_unique<DeformedBuffers>();
    } else {
        resource.morphCount = leadingMorphs(instance);
        if (resource.morphCount > 0)
            resource.morphBuffers = &morphBuffers(model, instance, resource.morphCount);
        needs_.morphs |= resource.morphCount > 0;
        if (resource.morphCount < instance.deformers.size()) {
            const Deformer& deformer = instance.deformers.back();
            resource.skin = deformer.index;
            resource.influences = deformer.influences;
            resource.influenceBuffers = &influenceBuffers(model, deformer.influences, instance.mesh);
            needs_.moreInfluences |= resource.influenceBuffers->more.has_value();
        }
    }
    if (!resource.deformedOnCpu && resource.morphCount == 0) resource.boxes = boxes(model, mesh, resource);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
        resource.parts.push_back(part(model, instance, i, resource));
    instances_.push_back(std::move(resource));
}

ModelResource::Part ModelResource::part(const Model& model, const MeshInstance& instance, std::size_t i,
                                        const Instance& resource) {
    const MeshData& mesh = model.meshes[index(instance.mesh)];
    PartMaterial bound = i < instance.materials.size() ? instance.materials[i] : PartMaterial{};
    bound.texCoordSets = neededSets(model, bound, mesh.texCoordSets.size());
    Part part{mesh.parts[i].primitive, mesh.parts[i].firstIndex, mesh.parts[i].indexCount, bound.material};
    part.vao = vaoFor(model, instance, bound, resource);
    needs_.vertexColors |= !mesh.colors.empty();
    if (!mayBeTransparent(model, bound.material)) return part;
    needs_.seeThrough = true;
    part.middle = middlePosition(mesh, mesh.parts[i]);
    return part;
}

std::size_t ModelResource::vaoFor(const Model& model, const MeshInstance& instance,
                                  const PartMaterial& material, const Instance& resource) {
    // Instances with equal keys share a vertex array. An instance deformed on the CPU has buffers of its own, so its
    // key contains its number.
    VaoKey key{instance.mesh, resource.influences, resource.morphBuffers ? 1 : 0,
               resource.deformedOnCpu ? static_cast<int>(instances_.size()) : -1};
    std::copy(material.texCoordSets.begin(), material.texCoordSets.end(), key.begin() + 4);
    const auto [found, isNew] = vaoOfKey_.try_emplace(key, vaos_.size());
    if (!isNew) return found->second;

    Vao& vao = vaos_.emplace_back();
    const MeshBuffers& mesh = meshBuffers(model, instance.mesh);
    mesh.feed(vao);
    if (resource.influenceBuffers) resource.influenceBuffers->feed(vao);
    if (resource.morphBuffers) resource.morphBuffers->feed(vao);
    for (std::size_t s = 0; s < material.texCoordSets.size(); ++s) {
        const int set = material.texCoordSets[s];
        if (set < 0 || mesh.texCoordSets[index(set)].empty()) continue;
        const auto location =
            VertexInput::kTextureCoords + (needs_.separateCoords ? static_cast<GLuint>(s) : 0u);
        vao.floats(location, mesh.texCoordSets[index(set)], 2);
    }
    // Last, so that they replace the mesh's own positions and normals.
    if (resource.deformed) resource.deformed->feed(vao);
    return found->second;
}

const MeshBuffers& ModelResource::meshBuffers(const Model& model, int mesh) {
    return meshes_.try_emplace(mesh, model.meshes[index(mesh)]).first->second;
}

const InfluenceBuffers& ModelResource::influenceBuffers(const Model& model, int influences, int mesh) {
    return influences_
        .try_emplace({influences, mesh}, model.influences[index(influences)], model.meshes[index(mesh)])
        .first->second;
}

const MorphBuffers& ModelResource::morphBuffers(const Model& model, const MeshInstance& instance,
                                                std::size_t count) {
    std::vector<int> key{instance.mesh};
    for (std::size_t i = 0; i < count; ++i) key.push_back(instance.deformers[i].index);
    return morphs_.try_emplace(std::move(key), model, instance).first->second;
}

}  // namespace walkcycle
