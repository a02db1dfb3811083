#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"

namespace walkcycle {

// One of the six transform elements of a <node> (COLLADA 1.4.1, chapter 5: <matrix>, <translate>, <rotate>,
// <scale>, <lookat>, <skew>), with its numbers as in the file.
struct TransformElement {
    enum class Kind { Matrix, Translate, Rotate, Scale, LookAt, Skew };
    Kind kind = Kind::Matrix;
    std::string sid;
    // The first valueCount() are used. Matrix: row by row. Rotate: the axis, then degrees. LookAt: eye, point
    // of interest, up. Skew: degrees, the axis to rotate, the axis to rotate it towards.
    std::array<double, 16> values{};
    int valueCount() const;  // 16 (Matrix), 3 (Translate, Scale), 4, 9 or 7
    XmlNode element;

    glm::dmat4 toMatrix() const;
};

// A node's transform elements in document order. Their product, the first element leftmost, is its local
// transform (COLLADA 1.4.1, chapter 5, <node>).
struct TransformStack {
    std::vector<TransformElement> elements;

    glm::dmat4 toMatrix() const;
};

// Reads a node's transform elements. Missing numbers are reported, and replaced by those of an element
// without effect.
TransformStack readTransformStack(XmlNode node, Diagnostics& diagnostics);

// The axis of a <rotate> (the first three of `values`) as a unit vector; zero if it has no length.
glm::dvec3 unitAxis(const double* values);

// The matrix of an element with these values. It is affine: its last row is 0 0 0 1.
glm::dmat4 matrixOf(TransformElement::Kind kind, const double* values);

}  // namespace walkcycle
