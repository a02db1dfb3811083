#pragma once

#include <string>

#include "walkcycle/model/Model.h"

namespace walkcycle {

// The clip that --clip names: by name or number (0 is the whole timeline), or the whole timeline for "all"
// and "". Null if "all" or "" is asked for and nothing moves. Throws UsageError if there is no such clip; the
// message lists all clips.
const Animation* findClip(const Model& model, const std::string& wanted);

// Converts a time of --time to a time of the document. With --clip, --time counts from the clip's start.
double documentTime(double seconds, const Animation* clip, const std::string& wantedClip);

}  // namespace walkcycle
