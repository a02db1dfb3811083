#pragma once

#include "loaders/context/LoadContext.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Fills bound.texCoordSets: for each texture of the material, the set of texture coordinates of the mesh that
// it uses. The effect gives the set a name ("UVSET0"), and a <bind_vertex_input> of `binding` (an
// <instance_material>) maps the name to a set. Without one, the quirk texcoord-by-number takes the number in
// the name; otherwise the first set is used.
void bindTexCoords(const Material& material, XmlNode binding, const MeshData& mesh, const MeshPart& part,
                   const LoadContext& context, PartMaterial& bound);

}  // namespace walkcycle
