#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "loaders/context/LoadContext.h"

namespace walkcycle {

// One <input> of a primitive: a corner's index number `offset` is an index into `source`.
struct CornerInput {
    std::shared_ptr<const FloatSource> source;  // null if the primitive has no such input
    std::size_t offset = 0;
    int set = 0;  // number of the texture coordinate set
};

// The <input>s of a primitive, together with those of its <vertices>, which are read by the index of the
// VERTEX input (COLLADA 1.4.1, chapter 5, <input> (shared), <vertices>).
struct PrimitiveInputs {
    CornerInput position;
    CornerInput normal;
    CornerInput color;
    std::vector<CornerInput> texCoords;  // one per set
    std::size_t stride = 1;              // indices per corner: one more than the largest offset

    // A primitive without positions cannot be drawn.
    bool usable() const { return position.source != nullptr; }
};

// A mesh's <vertices>, read once for all its primitives.
struct Vertices {
    XmlNode element;
    PrimitiveInputs inputs;
};
Vertices readVertices(XmlNode element, const LoadContext& context);

// Reads the inputs of a <triangles>, <polylist>, ... Faults are reported. If there are no positions, the
// result is not usable().
PrimitiveInputs readPrimitiveInputs(XmlNode primitive, const Vertices& vertices, const LoadContext& context);

}  // namespace walkcycle
