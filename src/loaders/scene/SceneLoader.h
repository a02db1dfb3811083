#pragma once

#include "loaders/context/LoadContext.h"
#include "loaders/scene/AnimationTargets.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The <visual_scene> to show: the one that the options name, or <scene> does, or the first. Throws LoadError where
// there is none.
XmlNode findVisualScene(XmlNode collada, const LoadContext& context);

// The scene's cameras and lights, and their elements for the channels that animate them.
void loadCameras(const SceneGraph& scene, const LoadContext& context, Model& model,
                 AnimationTargets& targets);
void loadLights(const SceneGraph& scene, const LoadContext& context, Model& model, AnimationTargets& targets);

// Model::nodeVisible: all but the nodes that the quirk extra-visibility hides.
// What hangs below a hidden node is not shown either.
void loadVisibility(const SceneGraph& scene, const LoadContext& context, Model& model);

}  // namespace walkcycle
