#include "walkcycle/model/Bounds.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "walkcycle/animation/Animator.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

// A node that is hidden at rest may become visible in an animation, if a channel animates its visibility.
bool mayBeSeen(const Model& model, int node) {
    const auto isVisibilityOfNode = [node](const Parameter& parameter) {
        return parameter.kind == ParameterKind::NodeVisible && parameter.object == node;
    };
    const auto i = static_cast<std::size_t>(node);
    return i >= model.nodeVisible.size() || model.nodeVisible[i] ||
           std::any_of(model.parameters.begin(), model.parameters.end(), isVisibilityOfNode);
}

}  // namespace

void Bounds::add(const glm::vec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
}

void Bounds::add(const Bounds& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
}

float Bounds::diagonal() const {
    return empty() ? 0.0f : glm::length(max - min);
}

Bounds bounds(const Model& model, const std::vector<glm::mat4>& modelTransforms,
              std::span<const float> parameters) {
    Bounds box;
    CpuSkinning skinning;
    std::vector<glm::vec3> positions;
    for (const MeshInstance& instance : model.instances) {
        if (!mayBeSeen(model, instance.node)) continue;
        skinning.positions(model, instance, modelTransforms, parameters, positions);
        // A mesh may have positions that no vertex uses; they are not drawn.
        const MeshData& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
        for (const std::uint32_t position : mesh.vertexPositions) box.add(positions[position]);
    }
    return box;
}

Bounds animatedBounds(const Model& model, const Animation* animation, int samples) {
    const std::vector<float> restParameters = model.restParameters();
    Animator animator(model.skeleton, restParameters);
    if (!animation) return bounds(model, animator.modelTransforms(), animator.parameters());

    Bounds box;
    animator.doAnimation(*animation);
    const int steps = std::max(samples - 1, 1);
    for (int i = 0; i <= steps; ++i) {
        animator.sampleAt(animation->startSeconds + animation->lengthInSeconds() * i / steps);
        box.add(bounds(model, animator.modelTransforms(), animator.parameters()));
    }
    return box;
}

}  // namespace walkcycle
