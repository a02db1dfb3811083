#pragma once

#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/geometry/LoadedMesh.h"
#include "loaders/geometry/PrimitiveInputs.h"
#include "loaders/geometry/PrimitiveReader.h"

namespace walkcycle {

// Makes what is drawn of the primitives that were read: checks every index, joins equal corners into vertices, cuts
// polygons into triangles, and makes the normals that the file does not have. Fills all of LoadedMesh but id, name,
// positionNormals and the file's hints.
void buildMesh(const PrimitiveInputs& vertices, const std::vector<PrimitiveCorners>& primitives,
               LoadedMesh& loaded, const LoadContext& context);

}  // namespace walkcycle
