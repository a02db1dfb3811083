#pragma once

#include <string_view>

namespace walkcycle {

// Whether the uploader of Second Life's viewer knows a joint of that name: a bone, an alias of one, a collision
// volume or an attachment point (these are Second Life's words) of indra/newview/character/avatar_skeleton.xml and
// avatar_lad.xml in github.com/secondlife/viewer.
bool isSecondLifeJoint(std::string_view name);

}  // namespace walkcycle
