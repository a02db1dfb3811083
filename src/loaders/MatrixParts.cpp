#include "loaders/MatrixParts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace walkcycle {

namespace {

// The part of `v` across `axis`, of unit length; zero where there is none beside rounding.
glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& axis, double smallest) {
    const glm::dvec3 rest = v - axis * glm::dot(v, axis);
    const double length = glm::length(rest);
    return length > smallest ? rest / length : glm::dvec3(0.0);
}

}  // namespace

glm::dmat4 MatrixParts::toMatrix() const {
    glm::dmat4 matrix(glm::mat3_cast(rotation) * stretch);
    matrix[3] = glm::dvec4(position, 1.0);
    return matrix;
}

// Gram-Schmidt, columns in order: x keeps its direction, y what is across x, z what is left.
MatrixParts partsOf(const glm::dmat4& matrix, const glm::dquat& near) {
    MatrixParts parts;
    parts.position = matrix[3];
    const glm::dmat3 linear(matrix);
    const glm::dmat3 open = glm::mat3_cast(near);
    const double size = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    const double smallest = size * 1e-9;

    glm::dvec3 x = across(linear[0], glm::dvec3(0.0), smallest);
    glm::dvec3 y = across(linear[1], x, smallest);
    const glm::dvec3 z = across(linear[2], glm::length(x) > 0.0 ? x : y, smallest);
    const bool noX = x == glm::dvec3(0.0), noY = y == glm::dvec3(0.0), noZ = z == glm::dvec3(0.0);
    parts.turns = int(noX) + int(noY) + int(noZ) <= 1;
    if (noX && !noY && !noZ)
        x = glm::cross(y, across(z, y, 0.0));
    else if (noX)
        x = noY && !noZ ? across(open[0], z, 1e-6) : across(open[0], y, 1e-6);
    if (x == glm::dvec3(0.0)) x = across(open[1], noY ? z : y, 1e-6);
    if (noY && !noZ) y = glm::cross(z, x);
    y = across(y, x, 1e-12);
    if (y == glm::dvec3(0.0)) y = across(open[1], x, 1e-6);
    if (y == glm::dvec3(0.0)) y = across(open[2], x, 1e-6);

    glm::dmat3 axes(x, y, glm::cross(x, y));
    if (!noX && !noY && !noZ && glm::determinant(linear) < 0.0)
        axes[0] = -axes[0], axes[2] = glm::cross(axes[0], axes[1]);
    parts.rotation = glm::normalize(glm::quat_cast(axes));
    if (glm::dot(parts.rotation, near) < 0.0) parts.rotation = -parts.rotation;
    parts.stretch = glm::transpose(axes) * linear;
    return parts;
}

MatrixParts blend(const MatrixParts& a, const MatrixParts& b, double progression) {
    MatrixParts parts;
    parts.position = glm::mix(a.position, b.position, progression);
    parts.rotation = turn(a.rotation, b.rotation, progression);
    parts.stretch = a.stretch * (1.0 - progression) + b.stretch * progression;
    return parts;
}

Turn::Turn(const glm::dquat& a, const glm::dquat& b) : a_(a), b_(b) {
    double cosine = glm::dot(a, b);
    if (cosine < 0.0) b_ = -b_;
    cosine = std::min(std::abs(cosine), 1.0);
    if (cosine > 1.0 - 1e-12) return;
    angle_ = std::acos(cosine);
    sine_ = std::sin(angle_);
}

glm::dquat Turn::at(double progression) const {
    if (sine_ == 0.0) return glm::normalize(a_ * (1.0 - progression) + b_ * progression);
    return (a_ * std::sin((1.0 - progression) * angle_) + b_ * std::sin(progression * angle_)) / sine_;
}

glm::dquat turn(const glm::dquat& a, const glm::dquat& b, double progression) {
    return Turn(a, b).at(progression);
}

}  // namespace walkcycle
