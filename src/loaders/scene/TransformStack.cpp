#include "loaders/scene/TransformStack.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "animation/RowMajor.h"
#include "loaders/sources/Source.h"

namespace walkcycle {

namespace {

using Kind = TransformElement::Kind;

struct KindInfo {
    const char* elementName;
    Kind kind;
    int valueCount;
    std::array<double, 16> neutral;  // replaces missing numbers
};

constexpr KindInfo kKinds[] = {
    {"matrix", Kind::Matrix, 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}},
    {"translate", Kind::Translate, 3, {}},
    {"rotate", Kind::Rotate, 4, {0, 0, 1, 0}},
    {"scale", Kind::Scale, 3, {1, 1, 1}},
    {"lookat", Kind::LookAt, 9, {0, 0, 0, 0, 0, -1, 0, 1, 0}},
    {"skew", Kind::Skew, 7, {0, 0, 1, 0, 1, 0, 0}},
};

glm::dvec3 vec3Of(const double* v) {
    return {v[0], v[1], v[2]};
}

bool isZero(const glm::dvec3& v) {
    return !(glm::dot(v, v) > 0.0);
}

// Divides by the largest component first, so that very long and very short vectors neither overflow nor
// underflow.
glm::dvec3 unit(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0.0 ? glm::normalize(v / largest) : glm::dvec3(0.0);
}

}  // namespace

glm::dvec3 unitAxis(const double* values) {
    return unit(vec3Of(values));
}

namespace {

glm::dmat4 rotation(const double* v) {
    const glm::dvec3 axis = unitAxis(v);
    return isZero(axis) ? glm::dmat4(1.0) : glm::rotate(glm::dmat4(1.0), glm::radians(v[3]), axis);
}

// The inverse of a view matrix: the node is at the eye, and its -Z axis points at the point of interest. If
// the up direction is zero or parallel to the view, another up direction is used.
glm::dmat4 lookAt(const double* v) {
    const glm::dvec3 eye = vec3Of(v);
    glm::dvec3 back = unit(eye - vec3Of(v + 3));
    if (isZero(back)) back = {0.0, 0.0, 1.0};
    glm::dvec3 right = glm::cross(unit(vec3Of(v + 6)), back);
    constexpr double kParallel = 1e-9;
    if (glm::length(right) < kParallel) {
        const glm::dvec3 up = std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
        right = glm::cross(up, back);
    }
    right = glm::normalize(right);
    const glm::dvec3 up = glm::cross(back, right);
    return {glm::dvec4(right, 0.0), glm::dvec4(up, 0.0), glm::dvec4(back, 0.0), glm::dvec4(eye, 1.0)};
}

// COLLADA's <skew> is RenderMan's Skew: an angle, the axis to rotate, and the axis along which points move.
// The first axis is rotated towards the second by the angle. A point moves in proportion to its distance from
// the second axis.
glm::dmat4 skew(const double* v) {
    const glm::dvec3 rotated = unit(vec3Of(v + 1));
    const glm::dvec3 along = unit(vec3Of(v + 4));
    const double inAlong = glm::dot(rotated, along);
    const glm::dvec3 across = rotated - along * inAlong;
    const double inAcross = glm::length(across);
    if (isZero(rotated) || isZero(along) || inAcross < 1e-9) return glm::dmat4(1.0);
    const double cosine = std::cos(glm::radians(v[0])), sine = std::sin(glm::radians(v[0]));
    const double newAcross = inAcross * cosine - inAlong * sine;
    const double newAlong = inAcross * sine + inAlong * cosine;
    if (newAcross < 1e-9)
        return glm::dmat4(1.0);  // the first axis would reach the second, or pass it: no skew does that
    const glm::dvec3 shift = along * (newAlong / newAcross - inAlong / inAcross);
    const glm::dvec3 a = across / inAcross;
    return {glm::dvec4(glm::dvec3(1, 0, 0) + shift * a.x, 0.0),
            glm::dvec4(glm::dvec3(0, 1, 0) + shift * a.y, 0.0),
            glm::dvec4(glm::dvec3(0, 0, 1) + shift * a.z, 0.0), glm::dvec4(0, 0, 0, 1)};
}

const KindInfo* kindOf(std::string_view elementName) {
    const auto* found = std::find_if(std::begin(kKinds), std::end(kKinds),
                                     [&](const KindInfo& kind) { return elementName == kind.elementName; });
    return found == std::end(kKinds) ? nullptr : found;
}

// Whether the element has no defined matrix, because an axis or direction is zero, or two directions are
// parallel.
bool isDegenerate(const TransformElement& e) {
    const double* v = e.values.data();
    switch (e.kind) {
        case Kind::Rotate:
            return isZero(vec3Of(v)) && v[3] != 0.0;
        case Kind::LookAt:
            return isZero(glm::cross(vec3Of(v) - vec3Of(v + 3), vec3Of(v + 6)));
        case Kind::Skew:
            return v[0] != 0.0 && skew(v) == glm::dmat4(1.0);
        case Kind::Matrix:
        case Kind::Translate:
        case Kind::Scale:
            return false;
    }
    return false;
}

TransformElement readElement(XmlNode node, const KindInfo& kind, Diagnostics& diagnostics) {
    TransformElement e{
        .kind = kind.kind, .sid = std::string(node.sid()), .values = kind.neutral, .element = node};
    const std::vector<double> numbers = readDoubles(node, diagnostics, NumberFaults::Error);
    const auto expected = static_cast<std::size_t>(kind.valueCount);
    if (numbers.size() != expected)
        diagnostics.report(Code::TransformNumbers, node,
                           {kind.elementName, std::to_string(expected), std::to_string(numbers.size())});
    std::copy_n(numbers.begin(), std::min(numbers.size(), expected), e.values.begin());
    if (isDegenerate(e)) diagnostics.report(Code::DegenerateTransform, node, {kind.elementName});
    return e;
}

}  // namespace

int TransformElement::valueCount() const {
    return kKinds[static_cast<std::size_t>(kind)].valueCount;
}

glm::dmat4 TransformElement::toMatrix() const {
    return matrixOf(kind, values.data());
}

glm::dmat4 TransformStack::toMatrix() const {
    glm::dmat4 product(1.0);
    for (const TransformElement& e : elements) product = product * e.toMatrix();
    return product;
}

glm::dmat4 matrixOf(Kind kind, const double* v) {
    switch (kind) {
        case Kind::Matrix:
            return affineFromRows<double>(v);
        case Kind::Translate:
            return glm::translate(glm::dmat4(1.0), vec3Of(v));
        case Kind::Rotate:
            return rotation(v);
        case Kind::Scale:
            return glm::scale(glm::dmat4(1.0), vec3Of(v));
        case Kind::LookAt:
            return lookAt(v);
        case Kind::Skew:
            return skew(v);
    }
    return glm::dmat4(1.0);
}

TransformStack readTransformStack(XmlNode node, Diagnostics& diagnostics) {
    TransformStack stack;
    for (XmlNode child : node.children())
        if (const KindInfo* kind = kindOf(child.name()))
            stack.elements.push_back(readElement(child, *kind, diagnostics));
    return stack;
}

}  // namespace walkcycle
