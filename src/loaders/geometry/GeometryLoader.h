#pragma once

#include "loaders/context/LoadContext.h"
#include "loaders/document/XmlNode.h"
#include "loaders/geometry/LoadedMesh.h"

namespace walkcycle {

// Reads a <geometry>: all its primitives, triangulated, corners joined into vertices, missing normals made.
// Reports faults and gives what can be drawn, possibly a mesh without parts (a morph target may have no primitives).
LoadedMesh loadGeometry(XmlNode geometry, const LoadContext& context);

}  // namespace walkcycle
