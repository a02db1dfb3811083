#pragma once

#include <cstdint>
#include <vector>

namespace walkcycle {

// The weight of one joint on a position. `joint` is an index into Skin::joints and the palette, not into the
// skeleton.
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
