#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "model/Model.h"

namespace walkcycle {

// One moment of a model: a transform per joint, to the model's space, and the positions of each instance.
template <typename Number>
struct PosedModel {
    std::vector<glm::mat<4, 4, Number>> joints;
    std::vector<std::vector<glm::vec<3, Number>>> positions;  // per instance, one per MeshData::positions
};

// The pose straight from the file's curves and transform stacks, hierarchy, morphs and skins in double: code of its
// own, beside Animator and CpuSkinning, so that one can be held against the other.
PosedModel<double> exactPose(const Model& model, double documentSeconds);

}  // namespace walkcycle
