#pragma once

#include <string>

#include "animation/Animator.h"
#include "model/Model.h"

namespace walkcycle {

// The model as it stands at the animator's moment, as a Wavefront OBJ: positions, normals, the first texture
// coordinates, one object per instance.
std::string poseObj(const Model& model, const Animator& animator);

}  // namespace walkcycle
