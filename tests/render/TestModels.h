#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "walkcycle/model/Model.h"

// Small models, made here rather than loaded: loaders and render never meet.
namespace walkcycle::testing_models {

inline MeshData withParts(MeshData mesh) {
    MeshPart part;
    part.indexCount = static_cast<std::uint32_t>(mesh.indices.size());
    mesh.parts.push_back(part);
    mesh.positionUsed.assign(mesh.positions.size(), true);
    return mesh;
}

// A square from -1 to 1 in x and y that faces +Z, its picture upright.
inline MeshData square() {
    MeshData mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.vertexPositions = {0, 1, 2, 3};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.texCoordSets = {{.set = 0, .coords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return withParts(mesh);
}

// A ball of radius 1, with more vertices than positions: each position has two, as along a seam.
inline MeshData ball(int rings = 12, int segments = 16) {
    MeshData mesh;
    constexpr double pi = 3.14159265358979323846;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s <= segments; ++s) {
            const double polar = pi * r / rings, around = 2.0 * pi * s / segments;
            const glm::vec3 p(std::sin(polar) * std::sin(around), std::cos(polar),
                              std::sin(polar) * std::cos(around));
            mesh.positions.push_back(p);
            mesh.normals.push_back(p);
            mesh.vertexPositions.push_back(static_cast<std::uint32_t>(mesh.positions.size() - 1));
        }
    }
    const auto at = [&](int r, int s) { return static_cast<std::uint32_t>(r * (segments + 1) + s); };
    for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < segments; ++s) {
            mesh.indices.insert(mesh.indices.end(), {at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.indices.insert(mesh.indices.end(), {at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
    }
    // The same points again in another order, so that a vertex's number is not its position's.
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        mesh.vertexPositions.push_back(count - 1 - i);
        mesh.normals.push_back(mesh.normals[count - 1 - i]);
    }
    return withParts(mesh);
}

inline Joint node(const glm::mat4& transform, int parent = kNoParent) {
    Joint joint;
    joint.parent = parent;
    joint.localBindTransform = transform;
    return joint;
}

inline Material colored(const glm::vec4& color) {
    Material material;
    material.slot(Slot::Diffuse) = {.present = true, .color = color, .texture = -1, .texCoordName = {}};
    return material;
}

inline Material glowing(const glm::vec4& color) {
    Material material;
    material.shading = ShadingModel::Constant;
    material.slot(Slot::Emission) = {.present = true, .color = color, .texture = -1, .texCoordName = {}};
    return material;
}

// One mesh on one node, with one material.
inline Model rigid(MeshData mesh, const glm::mat4& transform = glm::mat4(1.0f),
                   const Material& material = colored({0.8f, 0.8f, 0.8f, 1.0f})) {
    Model model;
    model.skeleton.joints.push_back(node(transform));
    model.nodeVisible = {true};
    model.materials.push_back(material);
    MeshInstance instance;
    instance.materials.assign(mesh.parts.size(), PartMaterial{.material = 0, .texCoordSets = {}});
    model.meshes.push_back(std::move(mesh));
    model.instances.push_back(instance);
    return model;
}

// A ball skinned to a chain of joints, each position pulled by `influencesPerPosition` of them. Joints turn, move and
// stretch unevenly, so that posed and bind transforms differ. The last palette entry is the skin's own node.
inline Model skinned(int joints, int influencesPerPosition) {
    Model model = rigid(ball());
    const glm::mat4 bindShape = glm::scale(glm::mat4(1.0f), glm::vec3(1.1f, 0.9f, 1.0f));
    Skin skin;
    for (int j = 0; j < joints; ++j) {
        const float t = static_cast<float>(j) / static_cast<float>(joints);
        glm::mat4 transform =
            glm::translate(glm::mat4(1.0f), glm::vec3(std::sin(7.0f * t), t, std::cos(3.0f * t)) * 0.6f);
        transform = glm::rotate(transform, 2.0f * t - 0.7f, glm::normalize(glm::vec3(1.0f, 0.5f + t, -t)));
        transform = glm::scale(transform, glm::vec3(0.7f + 0.5f * t, 1.0f, 1.3f - 0.6f * t));
        model.skeleton.joints.push_back(node(transform, 0));
        skin.joints.push_back(j + 1);
        const glm::mat4 bind = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, t, 0.2f * t));
        skin.bindMatrices.push_back(glm::rotate(bind, t, glm::vec3(0, 0, 1)) * bindShape);
    }
    skin.joints.push_back(0);
    skin.bindMatrices.push_back(bindShape);
    Influences influences;
    const auto positions = static_cast<int>(model.meshes[0].positions.size());
    for (int p = 0; p < positions; ++p) {
        influences.first.push_back(static_cast<std::uint32_t>(influences.influences.size()));
        const float total = static_cast<float>(influencesPerPosition * (influencesPerPosition + 1)) / 2.0f;
        for (int i = 0; i < influencesPerPosition; ++i) {
            const auto joint = static_cast<std::uint32_t>((p * 3 + i * 5) % joints);
            influences.influences.push_back({joint, static_cast<float>(i + 1) / total});
        }
    }
    influences.first.push_back(static_cast<std::uint32_t>(influences.influences.size()));
    model.nodeVisible.assign(model.skeleton.joints.size(), true);
    model.skins.push_back(skin);
    model.influences.push_back(influences);
    model.instances[0].deformers = {{.kind = Deformer::Kind::Skin, .index = 0, .influences = 0}};
    return model;
}

// Adds a morph beneath whatever deforms the first instance, its weights at rest as given.
inline void addMorph(Model& model, MorphMethod method, const std::vector<float>& weights) {
    const MeshData& mesh = model.meshes[0];
    MorphTargets morph;
    morph.method = method;
    morph.firstParameter = static_cast<int>(model.parameters.size());
    for (std::size_t t = 0; t < weights.size(); ++t) {
        MorphTarget target;
        const auto k = static_cast<float>(t + 1);
        for (const glm::vec3& p : mesh.positions)
            target.positionDeltas.push_back(p * glm::vec3(0.3f * k, 0.0f, p.y * 0.2f));
        for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
            target.normalDeltas.push_back(mesh.normals[v] * glm::vec3(-0.2f * k, 0.1f, 0.0f));
        }
        morph.targets.push_back(target);
        model.parameters.push_back({.kind = ParameterKind::MorphWeight,
                                    .object = static_cast<int>(model.morphs.size()),
                                    .component = static_cast<int>(t),
                                    .restValue = weights[t]});
    }
    const Deformer deformer{
        .kind = Deformer::Kind::Morph, .index = static_cast<int>(model.morphs.size()), .influences = 0};
    auto& deformers = model.instances[0].deformers;
    std::size_t at = 0;
    while (at < deformers.size() && deformers[at].kind == Deformer::Kind::Morph) ++at;
    deformers.insert(deformers.begin() + static_cast<std::ptrdiff_t>(at), deformer);
    model.morphs.push_back(morph);
}

}  // namespace walkcycle::testing_models
