#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "loaders/XmlNode.h"

namespace walkcycle {

class Diagnostics;

// One of the six transform elements of a <node> (COLLADA 1.4.1, chapter 5), with its numbers as in the file.
struct TransformElement {
    enum class Kind { Matrix, Translate, Rotate, Scale, LookAt, Skew };
    Kind kind = Kind::Matrix;
    std::string sid;
    std::array<double, 16> values{};  // Matrix: 16, row by row; Rotate: x y z degrees; Translate, Scale: 3; LookAt: 9; Skew: 7
    int valueCount() const;
    XmlNode element;

    glm::dmat4 toMatrix() const;
};

// A node's transform elements in document order; their product, first element leftmost, is its local transform.
struct TransformStack {
    std::vector<TransformElement> elements;

    glm::dmat4 toMatrix() const;
};

TransformStack readTransformStack(XmlNode node, Diagnostics& diagnostics);

}  // namespace walkcycle
