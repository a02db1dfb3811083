#pragma once

#include <cstddef>

#include "loaders/document/XmlNode.h"
#include "loaders/geometry/PrimitiveReader.h"

namespace walkcycle {

// Where one index of a corner is written in the file, for messages.
struct CornerLocation {
    XmlNode element;  // <p> or <h>; the primitive if the index is not found
    int line = 0;     // 1-based
};
// Finds the index number `offset` of a corner. For fans and strips, that is the index of the <p> from which
// the corner of a triangle or line was copied.
CornerLocation findCorner(const PrimitiveCorners& primitive, std::size_t corner, std::size_t offset);

}  // namespace walkcycle
