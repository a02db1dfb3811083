#pragma once

#include <string>
#include <vector>

#include "animation/Joint.h"

namespace walkcycle {

// A name for every joint that no other joint has: its id, else its name, else its sid; where that is taken (an
// occurrence of the same node by instance_node, or twins), its path from the root, "a/b/c".
std::vector<std::string> jointKeys(const Skeleton& skeleton);

}  // namespace walkcycle
