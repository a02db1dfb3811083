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

// The matrix that transforms the normals of one position: the cofactors of its blended skinning matrix. They
// are the inverse transpose up to a positive factor, and exist also if the skinning matrix flattens the mesh
// and has no inverse. Three columns, each in the order z, x, y, 0.
struct NormalMatrix {
    Float4 x, y, z;

    // For a matrix that mirrors, the columns are negated, and so the zeros in lane 3 are negative.
    bool isMirror() const { return std::signbit(x[3]); }
};

// Which instructions to use. Auto: AVX2 if the machine has it. The others are for tests and benchmarks; check
// with hasSkinningWay() first.
enum class SkinningWay { Auto, Baseline, Avx2 };
bool hasSkinningWay(SkinningWay way);

// Skins positions: each is multiplied by the sum of weight * palette[joint] over its influences. `to` is as
// long as `from`, and may be the same memory. Unless normalMatrices is null, it is resized and gets one entry
// per position.
void skinPositions(const Influences& influences, std::span<const glm::mat4> palette,
                   std::span<const glm::vec3> from, std::span<glm::vec3> to,
                   std::vector<NormalMatrix>* normalMatrices, SkinningWay way = SkinningWay::Auto);

// Transforms normals, each by the matrix of its position, and scales them to unit length. A normal without
// direction becomes zero. `to` is as long as `from`, and may be the same memory.
void transformNormals(std::span<const NormalMatrix> normalMatrices,
                      std::span<const std::uint32_t> vertexPositions, std::span<const glm::vec3> from,
                      std::span<glm::vec3> to, SkinningWay way = SkinningWay::Auto);

}  // namespace walkcycle
