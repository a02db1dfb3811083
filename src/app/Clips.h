#pragma once

#include <string>

#include "walkcycle/model/Model.h"

namespace walkcycle {

// The clip that the value of --clip means: a name, a number (0 is the whole timeline), or "all" or "" for the whole
// timeline. Null if the value is "all" or "" and the model has no clip. Throws UsageError if there is no such clip; the
// message lists all clips.
const Animation* findClip(const Model& model, const std::string& wanted);

// Converts a value of --time to a time of the document, in seconds. If --clip names a clip (not "all"), --time counts
// from the start of that clip.
double documentTime(double seconds, const Animation* clip, const std::string& wantedClip);

}  // namespace walkcycle
