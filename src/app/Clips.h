#pragma once

#include <string>

#include "model/Model.h"

namespace walkcycle {

// The clip that --clip means: a name, a number (0 is the whole timeline), or "all" or nothing for the whole timeline.
// Null where nothing moves and none was named. Throws UsageError that lists the clips.
const Animation* findClip(const Model& model, const std::string& wanted);

// Turns the times of --time into times of the document: they are clip-relative where a clip is named.
double documentTime(double seconds, const Animation* clip, const std::string& wantedClip);

}  // namespace walkcycle
