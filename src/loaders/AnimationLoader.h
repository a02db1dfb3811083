#pragma once

#include "loaders/LoadContext.h"
#include "loaders/SceneGraph.h"
#include "model/Model.h"

namespace walkcycle {

// Where the loaders put what a channel may target beside nodes: the element (by id) and what its numbers are.
struct AnimationTargets {
    std::unordered_map<XmlNode, int>
        morphs;  // <controller>, and its weights' <source> and <float_array> -> Model::morphs
    std::unordered_map<XmlNode, int> cameras;         // <camera> -> Model::cameras
    std::unordered_map<XmlNode, int> lights;          // <light> -> Model::lights
    std::unordered_multimap<XmlNode, int> materials;  // <effect> and <material> -> Model::materials
};

// Reads every <animation> and <animation_clip> of the root document, and what they move: fills model.animations,
// appends to model.parameters, sets model.exactMotion. All else of the model must be loaded.
void loadAnimations(XmlNode collada, const SceneGraph& scene, const AnimationTargets& targets,
                    const LoadContext& context, Model& model);

}  // namespace walkcycle
