#include "model/SkinningKernel.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <limits>

// Compiled twice: for any machine, and for machines with AVX2 and FMA. AVX2 loads a number into all lanes
// with one instruction; FMA multiplies and adds with one.
#if defined(__x86_64__)
#include <immintrin.h>
#define WALKCYCLE_HAS_AVX2 1
#define WALKCYCLE_AVX2 __attribute__((target("avx2,fma")))
#endif
#define WALKCYCLE_INLINE inline __attribute__((always_inline))

namespace walkcycle {
namespace {

using Bits = std::int32_t __attribute__((vector_size(16)));

// The columns of a matrix.
struct Columns {
    Float4 x, y, z, w;
};

WALKCYCLE_INLINE Float4 load(const float* numbers) {
    Float4 v;
    std::memcpy(&v, numbers, sizeof v);
    return v;
}

WALKCYCLE_INLINE void store(glm::vec3& into, Float4 v) {
    std::memcpy(&into.x, &v, sizeof into);
}

WALKCYCLE_INLINE Float4 yzx(Float4 v) {
    return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}
WALKCYCLE_INLINE Float4 zxy(Float4 v) {
    return __builtin_shufflevector(v, v, 2, 0, 1, 3);
}

// The cross product in the order z, x, y: this takes one shuffle less.
WALKCYCLE_INLINE Float4 crossZxy(Float4 a, Float4 b) {
    return a * yzx(b) - yzx(a) * b;
}

// The sign bit of the sum of the first three lanes, in every lane.
WALKCYCLE_INLINE Bits signOfSum(Float4 v) {
    const Float4 sum = splatLane<0>(v) + splatLane<1>(v) + splatLane<2>(v);
    return reinterpret_cast<Bits>(sum) & (Bits{} + INT32_MIN);
}

WALKCYCLE_INLINE Float4 negated(Float4 v, Bits sign) {
    return reinterpret_cast<Float4>(reinterpret_cast<Bits>(v) ^ sign);
}

// A matrix that mirrors has a negative determinant. It flips the faces, so the normals are negated to point
// outside again.
WALKCYCLE_INLINE NormalMatrix normalMatrixOf(Float4 x, Float4 y, Float4 z) {
    const Float4 xy = crossZxy(x, y);
    const Bits sign = signOfSum(xy * zxy(z));
    return {negated(crossZxy(y, z), sign), negated(crossZxy(z, x), sign), negated(xy, sign)};
}

// The weighted sum of the matrices that influence one position. Summing matrices costs as much as summing
// transformed positions would, and the sum also serves the normals.
WALKCYCLE_INLINE Columns blend(const Influence* first, const Influence* last, const glm::mat4* palette) {
    Columns sum{};
    for (; first != last; ++first) {
        const float* matrix = &palette[first->joint][0].x;
        const Float4 weight = splat(first->weight);
        sum.x += load(matrix) * weight;
        sum.y += load(matrix + 4) * weight;
        sum.z += load(matrix + 8) * weight;
        sum.w += load(matrix + 12) * weight;
    }
    return sum;
}

struct Points {
    const Influences& influences;
    const glm::mat4* palette;
    std::span<const glm::vec3> from;
    glm::vec3* to;
    NormalMatrix* normalMatrices;
};

template <bool kWithNormals>
void skinAll(const Points& points) {
    const Influence* all = points.influences.influences.data();
    const std::uint32_t* first = points.influences.first.data();
    for (std::size_t p = 0; p < points.from.size(); ++p) {
        const Columns m = blend(all + first[p], all + first[p + 1], points.palette);
        const glm::vec3 at = points.from[p];
        store(points.to[p], m.x * splat(at.x) + (m.y * splat(at.y) + (m.z * splat(at.z) + m.w)));
        if constexpr (kWithNormals) points.normalMatrices[p] = normalMatrixOf(m.x, m.y, m.z);
    }
}

struct Normals {
    const NormalMatrix* normalMatrices;
    const std::uint32_t* positions;
    std::span<const glm::vec3> from;
    glm::vec3* to;
};

// The transformed normal in the order z, x, y, not yet of unit length.
WALKCYCLE_INLINE Float4 transformed(const Normals& normals, std::size_t v) {
    const NormalMatrix& matrix = normals.normalMatrices[normals.positions[v]];
    const glm::vec3& normal = normals.from[v];
    return matrix.x * splat(normal.x) + (matrix.y * splat(normal.y) + matrix.z * splat(normal.z));
}

// Four vectors, each z, x, y, become x, y, z of unit length.
WALKCYCLE_INLINE void makeUnit(std::array<Float4, 4>& four) {
    transpose(four[0], four[1], four[2], four[3]);
    const Float4 z = four[0], x = four[1], y = four[2];
    const Float4 length = squareRoot(x * x + (y * y + z * z));
    const auto hasDirection = (length > splat(0.0f)) & (length <= splat(std::numeric_limits<float>::max()));
    const Float4 scale = hasDirection ? splat(1.0f) / length : splat(0.0f);
    four = {x * scale, y * scale, z * scale, splat(0.0f)};
    transpose(four[0], four[1], four[2], four[3]);
}

WALKCYCLE_INLINE void transformAll(const Normals& normals) {
    std::array<Float4, 4> four{};
    std::size_t v = 0;
    for (; v + 4 <= normals.from.size(); v += 4) {
        for (std::size_t i = 0; i < 4; ++i) four[i] = transformed(normals, v + i);
        makeUnit(four);
        for (std::size_t i = 0; i < 4; ++i) store(normals.to[v + i], four[i]);
    }
    const std::size_t rest = normals.from.size() - v;
    for (std::size_t i = 0; i < rest; ++i) four[i] = transformed(normals, v + i);
    makeUnit(four);
    for (std::size_t i = 0; i < rest; ++i) store(normals.to[v + i], four[i]);
}

#ifdef WALKCYCLE_HAS_AVX2
bool hasAvx2() {
    static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return has;
}
// Most of the time is spent on loading matrices. With two columns per register, half as many loads are
// needed.
WALKCYCLE_AVX2 void skinAvx2(const Points& points) {
    const Influence* all = points.influences.influences.data();
    const std::uint32_t* first = points.influences.first.data();
    for (std::size_t p = 0; p < points.from.size(); ++p) {
        __m256 xy = _mm256_setzero_ps(), zw = _mm256_setzero_ps();
        for (const Influence *i = all + first[p], *last = all + first[p + 1]; i != last; ++i) {
            const float* matrix = &points.palette[i->joint][0].x;
            const __m256 weight = _mm256_broadcast_ss(&i->weight);
            xy = _mm256_fmadd_ps(_mm256_loadu_ps(matrix), weight, xy);
            zw = _mm256_fmadd_ps(_mm256_loadu_ps(matrix + 8), weight, zw);
        }
        const Float4 x = _mm256_castps256_ps128(xy), y = _mm256_extractf128_ps(xy, 1);
        const Float4 z = _mm256_castps256_ps128(zw), w = _mm256_extractf128_ps(zw, 1);
        const glm::vec3 at = points.from[p];
        store(points.to[p], x * splat(at.x) + (y * splat(at.y) + (z * splat(at.z) + w)));
        if (points.normalMatrices) points.normalMatrices[p] = normalMatrixOf(x, y, z);
    }
}
WALKCYCLE_AVX2 void transformAvx2(const Normals& normals) {
    transformAll(normals);
}
#else
bool hasAvx2() {
    return false;
}
void skinAvx2(const Points&) {}
void transformAvx2(const Normals&) {}
#endif

bool takesAvx2(SkinningWay way) {
    return way == SkinningWay::Avx2 || (way == SkinningWay::Auto && hasAvx2());
}

}  // namespace

bool hasSkinningWay(SkinningWay way) {
    return way != SkinningWay::Avx2 || hasAvx2();
}

void skinPositions(const Influences& influences, std::span<const glm::mat4> palette,
                   std::span<const glm::vec3> from, std::span<glm::vec3> to,
                   std::vector<NormalMatrix>* normalMatrices, SkinningWay way) {
    assert(to.size() == from.size() && influences.first.size() == from.size() + 1);
    if (normalMatrices) normalMatrices->resize(from.size());
    const Points points{influences, palette.data(), from, to.data(),
                        normalMatrices ? normalMatrices->data() : nullptr};
    if (takesAvx2(way))
        skinAvx2(points);
    else if (normalMatrices)
        skinAll<true>(points);
    else
        skinAll<false>(points);
}

void transformNormals(std::span<const NormalMatrix> normalMatrices,
                      std::span<const std::uint32_t> vertexPositions, std::span<const glm::vec3> from,
                      std::span<glm::vec3> to, SkinningWay way) {
    assert(to.size() == from.size() && vertexPositions.size() == from.size());
    const Normals normals{normalMatrices.data(), vertexPositions.data(), from, to.data()};
    if (takesAvx2(way))
        transformAvx2(normals);
    else
        transformAll(normals);
}

}  // namespace walkcycle
