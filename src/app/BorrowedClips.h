#pragma once

#include <string>
#include <vector>

#include "model/Model.h"

namespace walkcycle {

// The clips of `source`, made to move the joints of `model` that have the same id, name or sid. Channels of
// other joints are left out. Distances are converted to the model's unit. Empty if the two share no joint.
std::vector<Animation> borrowClips(const Model& source, const Model& model);

}  // namespace walkcycle
