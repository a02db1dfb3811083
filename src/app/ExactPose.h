#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "walkcycle/model/Model.h"

namespace walkcycle {

// A model at one moment: the model transform of each joint, and the deformed positions of each instance in model space.
template <typename Number>
struct PosedModel {
    std::vector<glm::mat<4, 4, Number>> joints;
    std::vector<std::vector<glm::vec<3, Number>>> positions;  // per instance, one per MeshData::positions
};

// The pose in double precision, from the file's own curves and transform elements (Model::exactMotion) instead of key
// frames. It evaluates and deforms with code of its own, which shares only basic mathematics with Animator and
// CpuSkinning (SkinPlacement.h, Interpolation.h), so tests can compare the two.
PosedModel<double> exactPose(const Model& model, double documentSeconds);

}  // namespace walkcycle
