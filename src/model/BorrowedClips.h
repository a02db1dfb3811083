#pragma once

#include <stdexcept>
#include <vector>

#include "model/Model.h"

namespace walkcycle {

// Thrown by borrowClips where there is nothing that could be played.
struct NothingToBorrow : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The clips of `source` as they move `model`: for animations that are exported apart from their character. A channel
// moves the joint of `model` whose id, name or sid is the id, name or sid of its own joint (ids are looked for first);
// channels without such a joint are left out, and so are morph weights, cameras, lights and materials, which each file has
// for itself. Distances are scaled from the unit of the one document to that of the other; axes are not turned: both
// documents must have the same up axis.
//
// The result can be put behind Model::animations, or played by an Animator of the model's skeleton that it outlives.
// Throws NothingToBorrow, saying which, where `source` has no animation or none of its moving joints is in `model`.
std::vector<Animation> borrowClips(const Model& source, const Model& model);

}  // namespace walkcycle
