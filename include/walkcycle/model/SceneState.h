#pragma once

#include <span>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// The materials, cameras, lights and visibility of a model at one time. The constructor copies those of the
// model at rest. (Morph weights are not here: deformers take them from the parameters.)
struct WALKCYCLE_API SceneState {
    explicit SceneState(const Model& model);

    // Sets the values that parameters animate. `model` is that of the constructor, and `parameters` has one
    // value per Model::parameters. Allocates nothing.
    void apply(const Model& model, std::span<const float> parameters);

    std::vector<Material> materials;  // entries as in the vectors of Model
    std::vector<SceneCamera> cameras;
    std::vector<SceneLight> lights;
    std::vector<bool> nodeVisible;  // one per joint
};

}  // namespace walkcycle
