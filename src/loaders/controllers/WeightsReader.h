#pragma once

#include <cstddef>

#include "loaders/context/LoadContext.h"
#include "walkcycle/model/Influences.h"

namespace walkcycle {

// Reads <vertex_weights> for a mesh of `positionCount` positions and a skin of `jointCount` joints: any number of
// influences, normalised to a sum of one. Joint index -1, and positions without influences, get the entry `jointCount`,
// which stands for the skin's own node. Faults are reported.
Influences readWeights(XmlNode vertexWeights, std::size_t positionCount, std::size_t jointCount,
                       const LoadContext& context);

}  // namespace walkcycle
