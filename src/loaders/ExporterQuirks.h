#pragma once

#include "loaders/Diagnostics.h"
#include "loaders/XmlNode.h"
#include "model/Model.h"

namespace walkcycle {

// COLLADA's <transparency> is, with A_ONE, how opaque a thing is. Some exporters write how transparent it is instead:
//  - SketchUp before 7.1 always: the number is turned round (OpenCOLLADA and OpenSceneGraph do the same).
//  - Others, such as the scripts of Blender 2.4, write 0 for things that are simply solid. Nobody exports what cannot
//    be seen at all, so 0 with A_ONE is taken as 1.
// All else is as the format says: alpha 0 with A_ONE, or white with RGB_ZERO, is invisible (the conformance suite asks
// for it).
void correctTransparency(const Asset& asset, XmlNode transparency, std::string_view effect,
                         Diagnostics& diagnostics, Material& material);

}  // namespace walkcycle
