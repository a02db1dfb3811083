#pragma once

#include <cstdint>
#include <vector>

namespace walkcycle {

// One joint's pull on a position. `joint` is an index into Skin::joints (a palette entry), not a skeleton
// index.
struct Influence {
    std::uint32_t joint = 0;
    float weight = 0.0f;
};

// All influences of a mesh, shared by every instance of the skin: those of position p are
// influences[first[p]] .. influences[first[p + 1]], any number of them; their weights sum to one.
struct Influences {
    std::vector<std::uint32_t> first;  // positions + 1 entries
    std::vector<Influence> influences;
};

}  // namespace walkcycle
