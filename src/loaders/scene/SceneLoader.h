#pragma once

#include "loaders/context/LoadContext.h"
#include "loaders/scene/AnimationTargets.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The <visual_scene> to show: the one that LoadOptions::scene names (by id or name); otherwise the one of
// <scene>; otherwise, reported, the first. Throws LoadError if there is none.
XmlNode findVisualScene(XmlNode collada, const LoadContext& context);

// Read the cameras and lights that the scene instances, each once, and their instances. `targets` gets their
// elements, for the channels that animate them.
void loadCameras(const SceneGraph& scene, const LoadContext& context, Model& model,
                 AnimationTargets& targets);
void loadLights(const SceneGraph& scene, const LoadContext& context, Model& model, AnimationTargets& targets);

// Fills Model::nodeVisible: false for the nodes that the quirk extra-visibility hides. A hidden node also
// hides the nodes below it; their entries stay true.
void loadVisibility(const SceneGraph& scene, const LoadContext& context, Model& model);

}  // namespace walkcycle
