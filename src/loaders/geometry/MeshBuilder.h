#pragma once

#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/geometry/LoadedMesh.h"
#include "loaders/geometry/PrimitiveInputs.h"
#include "loaders/geometry/PrimitiveReader.h"

namespace walkcycle {

// Makes a mesh from the primitives that were read: checks every index, joins equal corners into vertices,
// cuts polygons into triangles, and computes the normals that the file does not have. `vertices` are the
// inputs of the mesh's <vertices>. Fills all of LoadedMesh but positionNormals and the mesh's id, name and
// doubleSided.
void buildMesh(const PrimitiveInputs& vertices, const std::vector<PrimitiveCorners>& primitives,
               LoadedMesh& loaded, const LoadContext& context);

}  // namespace walkcycle
