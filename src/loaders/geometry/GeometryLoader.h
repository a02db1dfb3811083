#pragma once

#include "loaders/context/LoadContext.h"
#include "loaders/document/XmlNode.h"
#include "loaders/geometry/LoadedMesh.h"

namespace walkcycle {

// Reads a <geometry> (COLLADA 1.4.1, chapter 5) and makes its mesh: polygons are cut into triangles, equal
// corners joined into vertices, and missing normals computed. Faults are reported. The result is what can be
// drawn in spite of them: possibly a mesh without parts, such as a morph target without primitives.
LoadedMesh loadGeometry(XmlNode geometry, const LoadContext& context);

}  // namespace walkcycle
