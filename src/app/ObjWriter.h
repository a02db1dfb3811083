#pragma once

#include <string>

#include "walkcycle/animation/Animator.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The model in the animator's present pose as a Wavefront OBJ: one object per instance, with positions,
// normals and the first set of texture coordinates.
std::string poseObj(const Model& model, const Animator& animator);

}  // namespace walkcycle
