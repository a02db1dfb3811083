#pragma once

#include <string>

#include "loaders/geometry/LoadedMesh.h"
#include "walkcycle/model/MorphTargets.h"

namespace walkcycle {

// What a target adds to the base at weight one. Targets may be longer than the base (the rest is ignored) or shorter
// (reported; the rest does not move), and without primitives (their normals then come from <vertices>, if at all).
MorphTarget makeMorphDeltas(const LoadedMesh& base, const LoadedMesh& target, MorphMethod method,
                            std::string id);

}  // namespace walkcycle
