#pragma once

#include <cstddef>

#include "walkcycle/model/MeshData.h"

namespace walkcycle {

// Fills mesh.tangents for a bump texture that uses texCoordSets[set]: per vertex the direction in which u grows along
// the surface, at a right angle to the normal, and in w the sign of the bitangent: cross(normal, tangent) * w is where
// v grows. Vertices whose texture coordinates say nothing get any direction along the surface.
//
// Faces that mirror the picture and meet in one vertex share the tangent of the larger side. (MikkTSpace would split
// the vertex; the difference shows only along the mirror line.)
void makeTangents(MeshData& mesh, std::size_t set);

}  // namespace walkcycle
