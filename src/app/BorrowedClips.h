#pragma once

#include <string>
#include <vector>

#include "model/Model.h"

namespace walkcycle {

// The clips of `source` as they move the joints of `model` that go by the same id, name or sid; what has no
// counterpart is left out. Distances are turned into the model's unit. Empty where no joint is shared.
std::vector<Animation> borrowClips(const Model& source, const Model& model);

}  // namespace walkcycle
