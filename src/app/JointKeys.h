#pragma once

#include <string>
#include <vector>

#include "walkcycle/animation/Joint.h"

namespace walkcycle {

// A unique name for every joint: its id, else its name, else its sid. If an earlier joint has that name
// already (two nodes of one name, or a node that <instance_node> shows again), its path from the root,
// "a/b/c".
std::vector<std::string> jointKeys(const Skeleton& skeleton);

}  // namespace walkcycle
