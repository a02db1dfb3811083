#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/geometry/PrimitiveInputs.h"
#include "walkcycle/model/MeshData.h"

namespace walkcycle {

// The corners of one <triangles>, <polylist>, <polygons>, <trifans>, <tristrips>, <lines> or <linestrips>
// (COLLADA 1.4.1, chapter 5). All have the same form here: rings of corners. Fans and strips are cut into
// triangles or lines.
struct PrimitiveCorners {
    XmlNode element;
    Primitive kind = Primitive::Triangles;
    PrimitiveInputs inputs;
    std::vector<std::int32_t> indices;  // inputs.stride per corner, corner after corner
    std::vector<Ring> rings;            // of two corners for lines

    std::size_t cornerCount() const { return indices.size() / inputs.stride; }
    const std::int32_t* corner(std::size_t c) const { return indices.data() + c * inputs.stride; }
};

// Reads the indices of the corners. They are not checked, and may be out of range. If <p>, <vcount> and
// `count` disagree, reports it and returns the faces that are complete.
PrimitiveCorners readPrimitive(XmlNode element, const Vertices& vertices, const LoadContext& context);

// The length of the primitive's index text in bytes, without polygons with holes (<ph>).
double textBytes(const PrimitiveCorners& primitive);

}  // namespace walkcycle
