#pragma once

#include <cstddef>

#include "loaders/context/LoadContext.h"
#include "walkcycle/model/Influences.h"

namespace walkcycle {

// Reads <vertex_weights> (COLLADA 1.4.1, chapter 5) for a mesh of `positionCount` positions and a skin of
// `jointCount` joints. A position may have any number of influences; their weights are scaled to the sum 1.
// Joint index -1, and positions without influences, get the joint `jointCount`, the entry of the skin's own
// node (see Skin). Faults are reported.
Influences readWeights(XmlNode vertexWeights, std::size_t positionCount, std::size_t jointCount,
                       const LoadContext& context);

}  // namespace walkcycle
