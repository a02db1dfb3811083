#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <walkcycle/Export.h>

namespace walkcycle {

struct MeshData;

// The weight of a joint for a position. `joint` is an index into Skin::joints and into the palette, not into
// Skeleton::joints.
struct Influence {
    std::uint32_t joint = 0;
    float weight = 0.0f;
};

// The influences of all positions of a mesh, shared by all instances of the skin (COLLADA 1.4.1, chapter 5,
// <vertex_weights>). Those of position p are influences[first[p]] to influences[first[p + 1] - 1]. A position
// has one or more; their weights sum to one.
struct Influences {
    std::vector<std::uint32_t> first;  // one entry per position, and one more: influences.size()
    std::vector<Influence> influences;
};

// The influences of a mesh in the form of a vertex buffer: `perVertex` joints and weights for each vertex.
// Those of vertex v are entries v * perVertex to (v + 1) * perVertex - 1, the largest weight first. Unused
// entries have joint 0 and weight 0.
struct LimitedInfluences {
    std::size_t perVertex = 0;
    std::vector<std::uint32_t> joints;  // indices into Skin::joints, and so into the palette
    std::vector<float> weights;         // the weights of a vertex sum to one

    // What the limit leaves out. Both are 0 if it leaves nothing out; limitingError() measures the effect in
    // a pose.
    std::size_t cutVertices = 0;  // vertices that have more influences than perVertex
    float largestDropped = 0.0f;  // the largest weight left out, before the others are scaled up
};

// Keeps the `most` influences with the largest weights of each vertex, and scales their weights so that they
// sum to one again. Of equal weights, the first ones are kept. Throws std::invalid_argument if `most` is 0,
// or if the influences are those of a mesh with another number of positions.
WALKCYCLE_API LimitedInfluences limitInfluences(const Influences& influences, const MeshData& mesh,
                                                std::size_t most);

// The error of limited influences in one pose: the largest distance between a vertex that follows all its
// influences and the same vertex that follows the limited ones. In model space: metres, unless
// LoadOptions::convert was off. `palette` is the result of computePalette() for the skin and the pose.
WALKCYCLE_API float limitingError(const LimitedInfluences& limited, const Influences& influences,
                                  const MeshData& mesh, std::span<const glm::mat4> palette);

}  // namespace walkcycle
