#pragma once

#include <span>
#include <vector>

#include "walkcycle/Export.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Private, but called by libwalkcycle-render, which is another shared library than the one that has src/model: hence
// WALKCYCLE_API.

// The coefficients of consecutive morphs: `deformers`, innermost first, all of Kind::Morph. The result of the
// morphs is base + sum of coefficients[i] * delta[i], where the deltas are those of all targets, in order. A
// NORMALIZED morph scales the coefficients of the morphs before it by (1 - sum of its weights). Resizes
// `coefficients` and reuses its memory.
WALKCYCLE_API void morphCoefficients(const Model& model, std::span<const Deformer> deformers,
                                     std::span<const float> parameters, std::vector<float>& coefficients);

// The factor of the input shape in the result of consecutive morphs: the product of (1 - sum of weights) over
// the NORMALIZED ones; 1 if there are none.
WALKCYCLE_API float shareOfInput(const Model& model, std::span<const Deformer> morphs,
                                 std::span<const float> parameters);

// Whether the normals of an instance are computed again for each deformed shape (see MadeNormals). Not if it
// has a bump texture, because tangents are computed only once, for the normals at rest.
WALKCYCLE_API bool makesNormals(const Model& model, const MeshInstance& instance);

// Whether the vertex shader can apply all deformers of an instance: any number of morphs, then at most one
// skin, and normals that the skin transforms. Otherwise, CpuSkinning deforms the instance, and its vertices
// are uploaded for each picture.
WALKCYCLE_API bool shaderCanDeform(const Model& model, const MeshInstance& instance);

}  // namespace walkcycle
