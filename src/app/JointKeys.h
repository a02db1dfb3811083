#pragma once

#include <string>
#include <vector>

#include "walkcycle/animation/Joint.h"

namespace walkcycle {

// A unique key for every joint: its id, else its name, else its sid. If an earlier joint has that key already (two
// nodes of one name, or a node that <instance_node> shows again), the key is its path from the root, "a/b/c"; if that
// is taken, too, a number follows, "a/b/c[2]".
std::vector<std::string> jointKeys(const Skeleton& skeleton);

}  // namespace walkcycle
