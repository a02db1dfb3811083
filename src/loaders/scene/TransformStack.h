#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"

namespace walkcycle {

// One of the six transform elements of a <node> (COLLADA 1.4.1, chapter 5), with its numbers as in the file.
struct TransformElement {
    enum class Kind { Matrix, Translate, Rotate, Scale, LookAt, Skew };
    Kind kind = Kind::Matrix;
    std::string sid;
    std::array<double, 16>
        values{};  // Matrix: 16, row by row; Rotate: x y z degrees; Translate, Scale: 3; LookAt: 9; Skew: 7
    int valueCount() const;
    XmlNode element;

    glm::dmat4 toMatrix() const;
};

// A node's transform elements in document order; their product, first element leftmost, is its local
// transform.
struct TransformStack {
    std::vector<TransformElement> elements;

    glm::dmat4 toMatrix() const;
};

// Reads a node's transform elements. Missing numbers are reported, and replaced by those of an element that does nothing.
TransformStack readTransformStack(XmlNode node, Diagnostics& diagnostics);

// The axis of a <rotate> as a unit vector, or zero if it has no length.
glm::dvec3 unitAxis(const double* values);

// The matrix of an element. It is affine: its last row is 0 0 0 1.
glm::dmat4 matrixOf(TransformElement::Kind kind, const double* values);

}  // namespace walkcycle
