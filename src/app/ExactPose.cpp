#include "app/ExactPose.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "animation/SkinPlacement.h"

namespace walkcycle {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

std::vector<glm::dmat4> worlds(const Skeleton& skeleton, std::span<const glm::dmat4> locals) {
    std::vector<glm::dmat4> result(locals.size());
    const glm::dmat4 root(skeleton.rootTransform);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const int parent = skeleton.joints[i].parent;
        result[i] = (parent == kNoParent ? root : result[at(parent)]) * locals[i];
    }
    return result;
}

// An instance while its deformers are applied. `points` are in model space if `placed`, otherwise in mesh space. A
// skin and place() move them to model space; unplace() moves them back, for a deformer after a skin.
struct Deformation {
    const Model& model;
    const MeshInstance& instance;
    const std::vector<glm::dmat4>& joints;
    std::span<const double> parameters;
    std::vector<glm::dvec3> points;
    bool placed = false;

    void transform(const glm::dmat4& matrix) {
        for (glm::dvec3& point : points) point = glm::dvec3(matrix * glm::dvec4(point, 1.0));
    }
    void place() {
        if (!placed) transform(joints[at(instance.node)]);
        placed = true;
    }
    void unplace() {
        if (placed) transform(inverseOrIdentity(joints[at(instance.node)]));
        placed = false;
    }
    void morph(const MorphTargets& morph);
    void skin(const Skin& skin, const Influences& influences);
    std::vector<glm::dmat4> palette(const Skin& skin) const;
};

// The NORMALIZED morph of COLLADA is (1 - sum of w) * base + sum of w * target. The model stores target - base, where
// base is the file's mesh; `points` may already be deformed.
void Deformation::morph(const MorphTargets& morph) {
    unplace();
    const std::vector<glm::vec3>& fileMesh = model.meshes[at(instance.mesh)].positions;
    const bool normalized = morph.method == MorphMethod::Normalized;
    double sum = 0.0;
    for (std::size_t t = 0; t < morph.targets.size(); ++t) sum += parameters[at(morph.firstParameter) + t];
    for (std::size_t p = 0; p < points.size(); ++p) {
        glm::dvec3 moved = points[p];
        if (normalized) moved = points[p] * (1.0 - sum) + glm::dvec3(fileMesh[p]) * sum;
        for (std::size_t t = 0; t < morph.targets.size(); ++t) {
            const std::vector<glm::vec3>& deltas = morph.targets[t].positionDeltas;
            if (p < deltas.size()) moved += parameters[at(morph.firstParameter) + t] * glm::dvec3(deltas[p]);
        }
        points[p] = moved;
    }
}

std::vector<glm::dmat4> Deformation::palette(const Skin& skin) const {
    glm::dmat4 placement(1.0);
    if (skin.placedBy != kNoParent)
        placement = skinPlacement(skin, [&](int joint) { return joints[at(joint)]; });
    std::vector<glm::dmat4> matrices(skin.joints.size());
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        const bool own = i + 1 == matrices.size();  // the skin's own node, which is in place already
        matrices[i] = (own ? glm::dmat4(1.0) : placement) * joints[at(skin.joints[i])] *
                      glm::dmat4(skin.bindMatrices[i]);
    }
    return matrices;
}

void Deformation::skin(const Skin& skin, const Influences& influences) {
    unplace();
    const std::vector<glm::dmat4> matrices = palette(skin);
    for (std::size_t p = 0; p < points.size(); ++p) {
        glm::dvec4 sum(0.0);
        for (std::uint32_t i = influences.first[p]; i < influences.first[p + 1]; ++i) {
            const Influence& influence = influences.influences[i];
            sum += static_cast<double>(influence.weight) *
                   (matrices[influence.joint] * glm::dvec4(points[p], 1.0));
        }
        points[p] = glm::dvec3(sum);
    }
    placed = true;
}

std::vector<glm::dvec3> deform(const Model& model, const MeshInstance& instance,
                               const std::vector<glm::dmat4>& joints, std::span<const double> parameters) {
    Deformation deformation{model, instance, joints, parameters, {}};
    for (const glm::vec3& position : model.meshes[at(instance.mesh)].positions)
        deformation.points.emplace_back(position);
    for (const Deformer& deformer : instance.deformers) {
        if (deformer.kind == Deformer::Kind::Morph)
            deformation.morph(model.morphs[at(deformer.index)]);
        else
            deformation.skin(model.skins[at(deformer.index)], model.influences[at(deformer.influences)]);
    }
    deformation.place();
    return std::move(deformation.points);
}

}  // namespace

PosedModel<double> exactPose(const Model& model, double documentSeconds) {
    std::vector<glm::dmat4> locals;
    std::vector<double> parameters;
    for (const Joint& joint : model.skeleton.joints) locals.emplace_back(joint.localBindTransform);
    for (const Parameter& parameter : model.parameters) parameters.push_back(parameter.restValue);
    if (model.exactMotion) model.exactMotion->evaluate(documentSeconds, locals, parameters);
    PosedModel<double> posed{worlds(model.skeleton, locals), {}};
    for (const MeshInstance& instance : model.instances)
        posed.positions.push_back(deform(model, instance, posed.joints, parameters));
    return posed;
}

}  // namespace walkcycle
