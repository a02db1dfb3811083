#pragma once

#include "loaders/context/LoadContext.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Fills `bound.texCoordSets`: which of the mesh's texture coordinates each of the material's pictures lies on. The
// effect gives them a name ("UVSET0"), and the <bind_vertex_input>s of `binding` (an <instance_material>) say which
// input set that is. Without one: what the quirk texcoord-by-number makes of the name, or else the first.
void bindTexCoords(const Material& material, XmlNode binding, const MeshData& mesh, const MeshPart& part,
                   const LoadContext& context, PartMaterial& bound);

}  // namespace walkcycle
