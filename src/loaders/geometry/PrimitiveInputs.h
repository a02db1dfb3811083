#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "loaders/context/LoadContext.h"

namespace walkcycle {

// One kind of data that corners have: where it comes from, and which of a corner's indices says which entry.
struct CornerInput {
    std::shared_ptr<const FloatSource> source;  // null where the primitive has no such data
    std::size_t offset = 0;
    int set = 0;
};

// What the <input>s of a primitive offer, those of its <vertices> included (they share the VERTEX input's index).
struct PrimitiveInputs {
    CornerInput position;
    CornerInput normal;
    CornerInput color;
    std::vector<CornerInput> texCoords;  // one per set
    std::size_t stride = 1;              // indices per corner: one more than the largest offset

    bool usable() const { return position.source != nullptr; }
};

// A mesh's <vertices>, read once for all its primitives.
struct Vertices {
    XmlNode element;
    PrimitiveInputs inputs;
};
Vertices readVertices(XmlNode element, const LoadContext& context);

// Reads the inputs of a <triangles>, <polylist>, ... Without positions (reported) the result is not usable.
PrimitiveInputs readPrimitiveInputs(XmlNode primitive, const Vertices& vertices, const LoadContext& context);

}  // namespace walkcycle
