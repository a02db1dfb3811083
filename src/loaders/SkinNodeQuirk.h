#pragma once

#include <string_view>

#include "loaders/LoadOptions.h"

namespace walkcycle {

// Whether the transform of an <instance_controller>'s node comes on top of the joints'. In the conformance suite's own
// pictures it does in the files of Maya (ColladaMaya) and Softimage (Crosswalk); in those of Blender, 3ds Max, FBX and
// SceneKit the joints alone place the skin, as four independent readers agree. The tool is the only thing that tells.
bool nodePlacesSkin(std::string_view authoringTool, SkinNode choice);

}  // namespace walkcycle
