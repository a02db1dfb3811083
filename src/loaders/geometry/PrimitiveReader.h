#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/geometry/PrimitiveInputs.h"
#include "walkcycle/model/MeshData.h"

namespace walkcycle {

// One <triangles>, <polylist>, <polygons>, <trifans>, <tristrips>, <lines> or <linestrips>, in the same form
// for all: rings of corners. Fans and strips are cut into their triangles and lines.
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

// Reads the indices of the corners without looking them up: they may be out of range. If <p>, <vcount> and
// count disagree, reports that and returns the complete faces.
PrimitiveCorners readPrimitive(XmlNode element, const Vertices& vertices, const LoadContext& context);

// How long the text of the corners is, in bytes; without that of polygons with holes.
double textBytes(const PrimitiveCorners& primitive);

// Where a corner's index stands in the file, for messages: the <p> or <h>, and the line. For fans and strips,
// that is the index from which the triangle's or line's corner was made.
struct CornerLocation {
    XmlNode element;
    int line = 0;
};
CornerLocation findCorner(const PrimitiveCorners& primitive, std::size_t corner, std::size_t offset);

}  // namespace walkcycle
