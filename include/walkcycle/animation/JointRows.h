#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <walkcycle/Export.h>

namespace walkcycle {

// An affine matrix, stored as its first three rows; the fourth is always 0 0 0 1. The palettes of crowds are made of
// these: they take a quarter less memory than glm::mat4.
struct alignas(16) JointRows {
    glm::vec4 rows[3] = {{1.0f, 0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f, 0.0f}};

    JointRows() = default;                    // the identity
    explicit JointRows(const glm::mat4& m) {  // `m` must be affine
        const glm::mat4 t = glm::transpose(m);
        for (int i = 0; i < 3; ++i) rows[i] = t[i];
    }
    glm::mat4 toMatrix() const {
        return glm::transpose(glm::mat4(rows[0], rows[1], rows[2], {0.0f, 0.0f, 0.0f, 1.0f}));
    }
};

// Multiplies each matrix of a palette by `placement` from the left: moves a character (or several) to its place.
WALKCYCLE_API void place(std::span<JointRows> palette, const glm::mat4& placement);

}  // namespace walkcycle
