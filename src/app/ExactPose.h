#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "walkcycle/model/Model.h"

namespace walkcycle {

// A model at one moment: per joint its model transform, and per instance its deformed positions in model
// space.
template <typename Number>
struct PosedModel {
    std::vector<glm::mat<4, 4, Number>> joints;
    std::vector<std::vector<glm::vec<3, Number>>> positions;  // per instance, one per MeshData::positions
};

// The pose in double precision, straight from the file's curves and transform stacks. It shares no code with
// Animator and CpuSkinning, so that each can be tested against the other.
PosedModel<double> exactPose(const Model& model, double documentSeconds);

}  // namespace walkcycle
