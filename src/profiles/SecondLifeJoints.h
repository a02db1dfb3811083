#pragma once

#include <string_view>

namespace walkcycle {

// Whether the viewer's uploader knows a joint of that name: the bones, their aliases, collision volumes and attachment
// points of indra/newview/character/avatar_skeleton.xml and avatar_lad.xml in github.com/secondlife/viewer.
bool isSecondLifeJoint(std::string_view name);

}  // namespace walkcycle
