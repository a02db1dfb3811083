#pragma once

#include <glm/mat4x4.hpp>

#include "loaders/context/LoadContext.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Reads the document's <asset>; LoadOptions::upAxis and metersPerUnit override it. A fault is reported, and the
// specification's default (1 metre, Y up) is used.
Asset readAsset(XmlNode collada, const LoadContext& context);

// The matrix from a space with this unit and up axis to metres with Y up.
// X_UP: (x, y, z) -> (-y, x, z); Z_UP: (x, y, z) -> (x, z, -y).
glm::dmat4 toMetresYUp(double metersPerUnit, UpAxis upAxis);

// The matrix from the space of `element` to the space of `around`: any element may have an <asset>, which applies to all
// elements inside that have none of their own, and other documents have theirs. Both elements may be of any document of
// the load. `document` is the root document's asset, with the options applied.
glm::dmat4 assetConversion(XmlNode element, XmlNode around, const Asset& document, XmlNode rootCollada);

}  // namespace walkcycle
