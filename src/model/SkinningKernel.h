#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "animation/Float4.h"
#include "walkcycle/model/Influences.h"

namespace walkcycle {

// The matrix by which a blended matrix transforms normals: its cofactors. They are the inverse transpose up
// to a positive factor, and exist even if the matrix flattens the mesh and has no inverse. Three columns,
// each in the order z, x, y, 0.
struct NormalMatrix {
    Float4 x, y, z;

    // The columns of a mirroring matrix are negated, and with them the zeros in lane 3.
    bool isMirror() const { return std::signbit(x[3]); }
};

// Auto takes AVX2 if the machine has it. The others are for tests and benchmarks; do not ask for a way that
// hasSkinningWay() denies.
enum class SkinningWay { Auto, Baseline, Avx2 };
bool hasSkinningWay(SkinningWay way);

// Skins positions: each becomes (sum of weight * palette[joint]) * position. Fills `normalMatrices` (resized, one per position)
// unless it is null. `to` is as long as `from`, and may be the same memory.
void skinPositions(const Influences& influences, std::span<const glm::mat4> palette,
                   std::span<const glm::vec3> from, std::span<glm::vec3> to,
                   std::vector<NormalMatrix>* normalMatrices, SkinningWay way = SkinningWay::Auto);

// Transforms normals, each by the matrix of its position, to unit length; a normal without direction becomes
// zero. `to` as above.
void transformNormals(std::span<const NormalMatrix> normalMatrices,
                      std::span<const std::uint32_t> vertexPositions, std::span<const glm::vec3> from,
                      std::span<glm::vec3> to, SkinningWay way = SkinningWay::Auto);

}  // namespace walkcycle
