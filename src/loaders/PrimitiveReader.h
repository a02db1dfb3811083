#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "loaders/LoadContext.h"
#include "loaders/PrimitiveInputs.h"
#include "model/MeshData.h"
#include "model/MeshFaces.h"

namespace walkcycle {

// One <triangles>, <polylist>, <polygons>, <trifans>, <tristrips>, <lines> or <linestrips>, all brought to the same
// form: rings of corners. Fans and strips are cut into their triangles and lines here, since that is how they are meant.
struct PrimitiveCorners {
    XmlNode element;
    Primitive kind = Primitive::Triangles;
    PrimitiveInputs inputs;
    std::vector<std::int32_t> indices;  // inputs.stride per corner, corner after corner
    std::vector<Ring> rings;            // of two corners for lines

    std::size_t cornerCount() const { return indices.size() / inputs.stride; }
    const std::int32_t* corner(std::size_t c) const { return indices.data() + c * inputs.stride; }
};

// Whether an element of this name is a primitive, lines included.
bool isPrimitive(XmlNode element);

// Reads the corners, not yet what they lead to: indices may be out of range. Where <p>, <vcount> and count disagree,
// that is reported, and the faces that are whole are given.
PrimitiveCorners readPrimitive(XmlNode element, const Vertices& vertices, const LoadContext& context);

// How long the text of the corners is, in bytes; without that of polygons with holes.
double textBytes(const PrimitiveCorners& primitive);

// Where a corner's index stands in the file, for messages: the <p> or <h>, and the line. (The primitive itself for
// fans and strips, whose corners are not the file's.)
struct CornerPlace {
    XmlNode element;
    int line = 0;
};
CornerPlace findCorner(const PrimitiveCorners& primitive, std::size_t corner, std::size_t offset);

}  // namespace walkcycle
