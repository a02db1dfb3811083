#pragma once

#include <span>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// The materials, cameras, lights and visibility of a model at one moment. The constructor takes the model's
// own values; apply() sets those that animated parameters change. (Morph weights are not here: they are read
// from the parameters.)
struct WALKCYCLE_API SceneState {
    explicit SceneState(const Model& model);

    void apply(const Model& model, std::span<const float> parameters);  // allocates nothing

    std::vector<Material> materials;
    std::vector<SceneCamera> cameras;
    std::vector<SceneLight> lights;
    std::vector<bool> nodeVisible;
};

}  // namespace walkcycle
