#pragma once

#include <span>
#include <vector>

#include "model/Model.h"

namespace walkcycle {

// The parts of a model that animated parameters change, as they are at one moment: start from the model's own
// values, then apply() each frame. Morph weights are read from the parameters directly.
struct SceneState {
    explicit SceneState(const Model& model);

    void apply(const Model& model, std::span<const float> parameters);  // allocates nothing

    std::vector<Material> materials;
    std::vector<SceneCamera> cameras;
    std::vector<SceneLight> lights;
    std::vector<bool> nodeVisible;
};

}  // namespace walkcycle
