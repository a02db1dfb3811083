#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <walkcycle/Export.h>

namespace walkcycle {

struct MeshData;

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

// The influences of a mesh in the form of a vertex buffer: `perVertex` joints and weights for each vertex that is drawn.
// Those of vertex v stand at [v * perVertex, (v + 1) * perVertex), the largest weight first. What a vertex does not use is
// joint 0 with weight 0.
struct LimitedInfluences {
    std::size_t perVertex = 0;
    std::vector<std::uint32_t> joints;  // indices into Skin::joints, and so into the palette
    std::vector<float> weights;         // those of a vertex sum to one

    // What the limit costs, before a pose is known. 0 and 0: nothing was left out.
    std::size_t cutVertices = 0;  // vertices that have more influences than perVertex
    float largestDropped =
        0.0f;  // the largest weight that was left out, as it was before the others were scaled up
};

// The `most` influences of each vertex that weigh most, scaled up so that they sum to one again; of equal ones those that
// come first. Throws std::invalid_argument where `most` is 0, or the influences are not those of a mesh with so many
// positions.
WALKCYCLE_API LimitedInfluences limitInfluences(const Influences& influences, const MeshData& mesh,
                                                std::size_t most);

// How far limiting moves a mesh in one pose: the largest distance between a vertex that follows all of its influences and
// the same one that follows the limited ones. In model space, in the unit of the palette's matrices: metres, unless the
// load converted nothing. `palette` is what computePalette() made of the skin and the pose.
WALKCYCLE_API float limitingError(const LimitedInfluences& limited, const Influences& influences,
                                  const MeshData& mesh, std::span<const glm::mat4> palette);

}  // namespace walkcycle
