#include "walkcycle/model/CpuSkinning.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "animation/SkinPlacement.h"
#include "model/Deformers.h"
#include "model/SkinningKernel.h"
#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

constexpr std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

// The matrix that transforms normals: the inverse transpose of `matrix`, up to a positive factor. Cross
// products give it also if `matrix` flattens the mesh and has no inverse.
glm::mat3 normalMatrix(const glm::mat4& matrix) {
    const glm::vec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
    const glm::mat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
    return glm::dot(cross(x, y), z) < 0.0f ? -cofactors : cofactors;
}

bool isMirror(const glm::mat4& matrix) {
    return glm::determinant(glm::mat3(matrix)) < 0.0f;
}

// A zero normal stays zero: vertices of lines have none.
glm::vec3 unit(const glm::vec3& normal) {
    const float length = glm::length(normal);
    return length > 0.0f && std::isfinite(length) ? normal / length : glm::vec3(0.0f);
}

void addScaled(std::vector<glm::vec3>& sums, const std::vector<glm::vec3>& deltas, float coefficient) {
    const std::size_t count = std::min(sums.size(), deltas.size());
    for (std::size_t i = 0; i < count; ++i) sums[i] += deltas[i] * coefficient;
}

void mixWith(std::vector<glm::vec3>& values, const std::vector<glm::vec3>& base, float share) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = values[i] * share + base[i] * (1.0f - share);
}

// An instance while its deformers are applied. Positions are in the space of the mesh, as morphs and skins
// expect, or after a skin in model space.
struct Work {
    const Model& model;
    const MeshInstance& instance;
    const MeshData& mesh;
    const std::vector<glm::mat4>& modelTransforms;
    std::span<const float> parameters;
    std::vector<glm::vec3>& positions;
    std::vector<glm::vec3>* normals;  // to be deformed; null if not needed
    std::vector<glm::vec3>* made;     // to be computed from the deformed shape; null if the mesh has normals
    bool inModelSpace = false;
    bool wasSkinned = false;
    bool mirrored = false;  // whether transform() has mirrored the mesh; for skins see Impl::mirrored

    const glm::mat4& nodeTransform() const { return modelTransforms[index(instance.node)]; }

    void transform(const glm::mat4& matrix) {
        for (glm::vec3& position : positions) position = glm::vec3(matrix * glm::vec4(position, 1.0f));
        if (isMirror(matrix)) mirrored = !mirrored;
        if (!normals) return;
        const glm::mat3 forNormals = normalMatrix(matrix);
        for (glm::vec3& normal : *normals) normal = unit(forNormals * normal);
    }

    void goToModelSpace() {
        if (!inModelSpace) transform(nodeTransform());
        inModelSpace = true;
    }

    void goToMeshSpace() {
        if (inModelSpace) transform(inverseOrIdentity(nodeTransform()));
        inModelSpace = false;
    }
};

}  // namespace

struct CpuSkinning::Impl {
    void deform(Work& work);
    void morph(Work& work, std::span<const Deformer> morphs);
    void skin(Work& work, const Deformer& deformer);
    void makeNormals(Work& work);

    // Kept between calls, so that a frame allocates nothing.
    std::vector<glm::mat4> palette;
    std::vector<float> coefficients;
    std::vector<NormalMatrix> normalMatrices;
    std::vector<glm::vec3> positions;
    std::vector<bool> mirrored;  // per position: whether its skins mirror it
    SmoothNormals smoothNormals;
};

void CpuSkinning::Impl::morph(Work& work, std::span<const Deformer> morphs) {
    work.goToMeshSpace();
    // Deltas are relative to the mesh of the file. After a skin, the input of the morphs is another shape, so
    // it is blended towards the mesh of the file first, as far as NORMALIZED morphs ask for.
    if (work.wasSkinned) {
        const float share = shareOfInput(work.model, morphs, work.parameters);
        mixWith(work.positions, work.mesh.positions, share);
        if (work.normals) mixWith(*work.normals, work.mesh.normals, share);
    }
    morphCoefficients(work.model, morphs, work.parameters, coefficients);
    std::size_t next = 0;
    for (const Deformer& deformer : morphs) {
        for (const MorphTarget& target : work.model.morphs[index(deformer.index)].targets) {
            const float coefficient = coefficients[next++];
            if (coefficient == 0.0f) continue;
            addScaled(work.positions, target.positionDeltas, coefficient);
            if (work.normals) addScaled(*work.normals, target.normalDeltas, coefficient);
        }
    }
}

void CpuSkinning::Impl::skin(Work& work, const Deformer& deformer) {
    work.goToMeshSpace();
    computePalette(work.model.skins[index(deformer.index)], work.modelTransforms, palette);
    const Influences& influences = work.model.influences[index(deformer.influences)];
    assert(influences.first.size() == work.positions.size() + 1);
    skinPositions(influences, palette, work.positions, work.positions,
                  work.normals || work.made ? &normalMatrices : nullptr);
    if (work.normals)
        transformNormals(normalMatrices, work.mesh.vertexPositions, *work.normals, *work.normals);
    for (std::size_t p = 0; work.made && p < normalMatrices.size(); ++p)
        if (normalMatrices[p].isMirror()) mirrored[p] = !mirrored[p];
    work.inModelSpace = true;
    work.wasSkinned = true;
}

// Creases are those of the deformed shape: faces that are flat at rest may be folded now. If a deformer
// mirrors the surface, its normals are negated to point outside again.
void CpuSkinning::Impl::makeNormals(Work& work) {
    const MadeNormals& mesh = work.mesh.madeNormals;
    const std::vector<glm::vec3>& normals =
        smoothNormals.make(mesh.faces, mesh.meetings, work.positions, work.positions);
    for (std::size_t c = 0; c < normals.size(); ++c) {
        const std::uint32_t vertex = mesh.cornerVertices[c];
        if (vertex == kNoVertex) continue;
        const bool inside = mirrored[work.mesh.vertexPositions[vertex]] != work.mirrored;
        (*work.made)[vertex] = inside ? -normals[c] : normals[c];
    }
    work.normals = work.made;  // the last transform applies to them, too
}

void CpuSkinning::Impl::deform(Work& work) {
    const std::span<const Deformer> deformers = work.instance.deformers;
    for (std::size_t i = 0; i < deformers.size();) {
        if (deformers[i].kind == Deformer::Kind::Skin) {
            skin(work, deformers[i++]);
            continue;
        }
        const std::size_t first = i;
        while (i < deformers.size() && deformers[i].kind == Deformer::Kind::Morph) ++i;
        morph(work, deformers.subspan(first, i - first));
    }
    if (work.made) makeNormals(work);
    work.goToModelSpace();
}

CpuSkinning::CpuSkinning() : impl_(std::make_unique<Impl>()) {}
CpuSkinning::~CpuSkinning() = default;
CpuSkinning::CpuSkinning(CpuSkinning&&) noexcept = default;
CpuSkinning& CpuSkinning::operator=(CpuSkinning&&) noexcept = default;

void CpuSkinning::positions(const Model& model, const MeshInstance& instance,
                            const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                            std::vector<glm::vec3>& out) {
    const MeshData& mesh = model.meshes[index(instance.mesh)];
    out = mesh.positions;
    Work work{model, instance, mesh, modelTransforms, parameters, out, nullptr, nullptr};
    impl_->deform(work);
}

void CpuSkinning::vertices(const Model& model, const MeshInstance& instance,
                           const std::vector<glm::mat4>& modelTransforms, std::span<const float> parameters,
                           std::vector<glm::vec3>& outPositions, std::vector<glm::vec3>& outNormals) {
    const MeshData& mesh = model.meshes[index(instance.mesh)];
    assert(mesh.normals.size() == mesh.vertexCount());
    std::vector<glm::vec3>& positions = impl_->positions;
    positions = mesh.positions;
    outNormals = mesh.normals;
    const bool makes = makesNormals(model, instance);
    if (makes) impl_->mirrored.assign(mesh.positions.size(), false);
    Work work{model,
              instance,
              mesh,
              modelTransforms,
              parameters,
              positions,
              makes ? nullptr : &outNormals,
              makes ? &outNormals : nullptr};
    impl_->deform(work);
    if (makes)  // other normals have unit length already
        for (glm::vec3& normal : outNormals) normal = unit(normal);
    outPositions.resize(mesh.vertexCount());
    for (std::size_t v = 0; v < outPositions.size(); ++v)
        outPositions[v] = positions[mesh.vertexPositions[v]];
}

}  // namespace walkcycle
