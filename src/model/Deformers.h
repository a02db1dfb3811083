#pragma once

#include <span>
#include <vector>

#include "walkcycle/Export.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Private, but libwalkcycle-render, which is another shared library than the one of src/model, asks these, too.

// The coefficient of every delta of a run of morphs (`deformers`, innermost first, all of Kind::Morph): the
// result is base + sum of coefficients[i] * delta i, targets counted through the stack in order. NORMALIZED
// layers scale what lies beneath them by (1 - sum of w). Resizes `coefficients`, reusing its memory.
WALKCYCLE_API void morphCoefficients(const Model& model, std::span<const Deformer> deformers,
                                     std::span<const float> parameters, std::vector<float>& coefficients);

// How much of the shape that a run of morphs is applied to is left in its result: all of it (1), except for NORMALIZED
// layers.
WALKCYCLE_API float shareOfInput(const Model& model, std::span<const Deformer> morphs,
                                 std::span<const float> parameters);

// Whether the normals of an instance are computed again for each shape that its deformers give it. (Not if it has a bump
// texture: that needs tangents, which are computed only once.)
WALKCYCLE_API bool makesNormals(const Model& model, const MeshInstance& instance);

// Whether the vertex shader can do an instance's deformers: leading morphs, then at most one skin, and normals that rotate
// with the vertices. If false, CpuSkinning deforms the instance, and its vertices are uploaded for each picture.
WALKCYCLE_API bool shaderCanDeform(const Model& model, const MeshInstance& instance);

}  // namespace walkcycle
