#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace walkcycle {

// Four floats in one register, as a vector type of GCC and clang: the usual operators work on all four lanes, and the
// compiler makes SSE, NEON or plain code of them.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 splat(float x) {
    return Float4{x, x, x, x};
}

inline Float4 squareRoot(Float4 v) {
#ifdef __SSE2__
    return _mm_sqrt_ps(v);
#else
    return Float4{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
#endif
}

template <int kLane>
Float4 splatLane(Float4 v) {
    return __builtin_shufflevector(v, v, kLane, kLane, kLane, kLane);
}

// (x, y, z, w) becomes (0, 0, 0, w).
inline Float4 onlyLast(Float4 v) {
    using Bits = std::int32_t __attribute__((vector_size(16)));
    return reinterpret_cast<Float4>(reinterpret_cast<Bits>(v) & Bits{0, 0, 0, -1});
}

// Transposes the 4x4 matrix with the rows a, b, c, d: lane i of the four becomes row i.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
    const Float4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5),
                 cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Float4 abHigh = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const Float4 cdHigh = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    a = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    c = __builtin_shufflevector(abHigh, cdHigh, 0, 1, 4, 5);
    d = __builtin_shufflevector(abHigh, cdHigh, 2, 3, 6, 7);
}

}  // namespace walkcycle
