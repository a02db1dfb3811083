#pragma once

#include <string>

#include "loaders/geometry/LoadedMesh.h"
#include "walkcycle/model/MorphTargets.h"

namespace walkcycle {

// The morph target that adds, at weight 1, the deltas between `target` and `base` (see MorphTarget). A
// RELATIVE target holds position deltas already. If `target` has more positions than `base`, the others are
// ignored; if it has fewer, the other deltas are zero. Normal deltas come from the target's normals if they
// fit, and otherwise from the shape.
MorphTarget makeMorphDeltas(const LoadedMesh& base, const LoadedMesh& target, MorphMethod method,
                            std::string id);

}  // namespace walkcycle
