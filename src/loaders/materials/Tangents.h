#pragma once

#include <cstddef>

#include "walkcycle/model/MeshData.h"

namespace walkcycle {

// Fills mesh.tangents for a bump texture that uses texCoordSets[set]. Per vertex: the direction along the
// surface in which u grows, at a right angle to the normal; and in w the sign of the bitangent, cross(normal,
// tangent) * w, the direction in which v grows. If the texture coordinates give no direction, any direction
// along the surface is used.
//
// Faces that mirror the picture and meet in one vertex share the tangent of the larger side. (MikkTSpace
// would split the vertex; the difference shows only along the mirror line.)
void makeTangents(MeshData& mesh, std::size_t set);

}  // namespace walkcycle
