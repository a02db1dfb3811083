#include "model/Deformers.h"

#include <cassert>
#include <cstddef>

namespace walkcycle {
namespace {

constexpr std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

float weightSum(const MorphTargets& morph, std::span<const float> parameters) {
    float sum = 0.0f;
    for (std::size_t t = 0; t < morph.targets.size(); ++t) sum += parameters[index(morph.firstParameter) + t];
    return sum;
}

}  // namespace

void morphCoefficients(const Model& model, std::span<const Deformer> deformers,
                       std::span<const float> parameters, std::vector<float>& coefficients) {
    coefficients.clear();
    for (const Deformer& deformer : deformers) {
        assert(deformer.kind == Deformer::Kind::Morph);
        const MorphTargets& morph = model.morphs[index(deformer.index)];
        if (morph.method == MorphMethod::Normalized) {
            const float left = 1.0f - weightSum(morph, parameters);
            for (float& coefficient : coefficients) coefficient *= left;
        }
        for (std::size_t t = 0; t < morph.targets.size(); ++t) {
            coefficients.push_back(parameters[index(morph.firstParameter) + t]);
        }
    }
}

float shareOfInput(const Model& model, std::span<const Deformer> morphs, std::span<const float> parameters) {
    float share = 1.0f;
    for (const Deformer& deformer : morphs) {
        const MorphTargets& morph = model.morphs[index(deformer.index)];
        if (morph.method == MorphMethod::Normalized) share *= 1.0f - weightSum(morph, parameters);
    }
    return share;
}

bool makesNormals(const Model& model, const MeshInstance& instance) {
    const MeshData& mesh = model.meshes[index(instance.mesh)];
    return !instance.deformers.empty() && !mesh.madeNormals.faces.rings.empty() && mesh.tangents.empty();
}

bool shaderCanDeform(const Model& model, const MeshInstance& instance) {
    if (makesNormals(model, instance)) return false;
    std::size_t morphs = 0;
    while (morphs < instance.deformers.size() && instance.deformers[morphs].kind == Deformer::Kind::Morph)
        ++morphs;
    return morphs + 1 >= instance.deformers.size();
}

}  // namespace walkcycle
