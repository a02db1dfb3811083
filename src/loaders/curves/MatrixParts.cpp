#include "loaders/curves/MatrixParts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "animation/Interpolation.h"

namespace walkcycle {

namespace {

// The unit vector along the part of `v` at right angles to `axis`; zero if that part is not longer than
// `smallest`.
glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& axis, double smallest) {
    const glm::dvec3 rest = v - axis * glm::dot(v, axis);
    const double length = glm::length(rest);
    return length > smallest ? rest / length : glm::dvec3(0.0);
}

// An axis this much shorter than the longest one is a rounding error.
constexpr double kLost = 1e-9;

// Gram-Schmidt: x keeps its direction, y is made orthogonal to x, z to both. Returns false if one of them is
// lost, that is, scaled to nothing.
bool findAxes(const glm::dmat3& linear, glm::dmat3& axes) {
    const glm::dvec3 squares(glm::dot(linear[0], linear[0]), glm::dot(linear[1], linear[1]),
                             glm::dot(linear[2], linear[2]));
    const double smallest = kLost * kLost * std::max({squares.x, squares.y, squares.z});
    if (!(squares.x > smallest)) return false;
    const glm::dvec3 x = linear[0] / std::sqrt(squares.x);
    glm::dvec3 y = linear[1] - x * glm::dot(linear[1], x);
    const glm::dvec3 z = linear[2] - x * glm::dot(linear[2], x);
    const double square = glm::dot(y, y);
    if (!(square > smallest) || !(glm::dot(z, z) > smallest)) return false;
    y /= std::sqrt(square);
    // If y was nearly parallel to x, its rounding errors are large: once more.
    if (square < 0.01 * squares.y) y = across(y, x, 0.0);
    axes = {x, y, glm::cross(x, y)};
    if (glm::dot(axes[2], linear[2]) < 0.0) axes[0] = -axes[0], axes[2] = -axes[2];
    return true;
}

// The same for a matrix with lost axes: keeps the others, and takes the lost ones from the rotation `near`.
// Returns false if two or more axes are lost, so that the result is hardly more than `near`.
bool guessAxes(const glm::dmat3& linear, const glm::dquat& near, glm::dmat3& axes) {
    const glm::dmat3 open = glm::mat3_cast(near);
    const double size = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    const double smallest = size * kLost;
    glm::dvec3 x = across(linear[0], glm::dvec3(0.0), smallest);
    glm::dvec3 y = across(linear[1], x, smallest);
    const glm::dvec3 z = across(linear[2], glm::length(x) > 0.0 ? x : y, smallest);
    const bool noX = x == glm::dvec3(0.0), noY = y == glm::dvec3(0.0), noZ = z == glm::dvec3(0.0);
    if (noX && !noY && !noZ)
        x = glm::cross(y, across(z, y, 0.0));
    else if (noX)
        x = noY && !noZ ? across(open[0], z, 1e-6) : across(open[0], y, 1e-6);
    if (x == glm::dvec3(0.0)) x = across(open[1], noY ? z : y, 1e-6);
    if (noY && !noZ) y = glm::cross(z, x);
    y = across(y, x, 1e-12);
    if (y == glm::dvec3(0.0)) y = across(open[1], x, 1e-6);
    if (y == glm::dvec3(0.0)) y = across(open[2], x, 1e-6);
    axes = {x, y, glm::cross(x, y)};
    return int(noX) + int(noY) + int(noZ) <= 1;
}

}  // namespace

glm::dmat4 MatrixParts::toMatrix() const {
    glm::dmat4 matrix(glm::mat3_cast(rotation) * stretch);
    matrix[3] = glm::dvec4(position, 1.0);
    return matrix;
}

MatrixParts partsOf(const glm::dmat4& matrix, const glm::dquat& near) {
    const glm::dmat3 linear(matrix);
    MatrixParts parts;
    parts.position = matrix[3];
    glm::dmat3 axes;
    if (!findAxes(linear, axes)) parts.hasRotation = guessAxes(linear, near, axes);
    parts.rotation = glm::normalize(glm::quat_cast(axes));
    if (glm::dot(parts.rotation, near) < 0.0) parts.rotation = -parts.rotation;
    parts.stretch = glm::transpose(axes) * linear;
    return parts;
}

MatrixParts blend(const MatrixParts& a, const MatrixParts& b, double progression) {
    MatrixParts parts;
    parts.position = glm::mix(a.position, b.position, progression);
    parts.rotation = Slerp(a.rotation, b.rotation).at(progression);
    parts.stretch = a.stretch * (1.0 - progression) + b.stretch * progression;
    return parts;
}

}  // namespace walkcycle
