#pragma once

#include <optional>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The elements of a <mesh> that hold faces or lines (COLLADA 1.4.1, chapter 5).
enum class PrimitiveKind { Triangles, Polylist, Polygons, Trifans, Tristrips, Lines, Linestrips };

// Nothing if the element is none of them.
std::optional<PrimitiveKind> primitiveKindOf(XmlNode element);

}  // namespace walkcycle
