#pragma once

#include <glm/mat4x4.hpp>

#include "loaders/context/LoadContext.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The document's <asset>, with what the options say instead of it. Faults are reported, and the specification's
// defaults (1 metre, Y up) stand in.
Asset readAsset(XmlNode collada, const LoadContext& context);

// From a space with this unit and up axis to Y-up metres. X_UP: (x, y, z) -> (-y, x, z); Z_UP: (x, y, z) -> (x, z, -y).
glm::dmat4 toMetresYUp(double metersPerUnit, UpAxis upAxis);

// An <asset> may stand on any element and speaks for everything inside it that has none of its own; other documents
// have their own. This is the way from the space of `element` to the space of `around` (both elements of any of the
// load's documents; `document` is the root document's asset, for it as the options see it).
glm::dmat4 assetConversion(XmlNode element, XmlNode around, const Asset& document, XmlNode rootCollada);

}  // namespace walkcycle
