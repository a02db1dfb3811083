#pragma once

#include <array>
#include <cstddef>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace walkcycle {

// Files, and `pose --json`, write a matrix row by row; glm::mat4 stores columns.

template <typename Number>
glm::vec<4, Number> rowOf(const glm::mat<4, 4, Number>& matrix, int row) {
    return {matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]};
}

template <typename Number>
std::array<Number, 16> rowsOf(const glm::mat<4, 4, Number>& matrix) {
    std::array<Number, 16> rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = matrix[static_cast<glm::length_t>(i % 4)][static_cast<glm::length_t>(i / 4)];
    return rows;
}

// Takes 12 numbers. The last row of an affine matrix is 0 0 0 1; other numbers of a file there are noise.
template <typename Number, typename Written>
glm::mat<4, 4, Number> affineFromRows(const Written* rows) {
    glm::mat<4, 4, Number> matrix(Number(1));
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = static_cast<Number>(rows[row * 4 + column]);
    return matrix;
}

}  // namespace walkcycle
