#pragma once

#include <memory>
#include <vector>

#include "loaders/context/LoadContext.h"
#include "loaders/curves/ClipLoader.h"
#include "loaders/curves/Motion.h"
#include "loaders/document/XmlNode.h"
#include "loaders/scene/AnimationTargets.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The exact motion of a document: its curves, bound to joints and parameters, and the clips that
// <animation_clip>s cut out of it.
struct LoadedMotion {
    std::shared_ptr<const Motion> motion;  // null if nothing is animated
    std::vector<ClipRange> clips;
};

// Reads every <animation> and <animation_clip> of the root document, and appends the parameters that they
// animate to model.parameters. All other parts of the model must be loaded before. AnimationFitter makes key
// frames of the result.
LoadedMotion loadAnimations(XmlNode collada, const SceneGraph& scene, const AnimationTargets& targets,
                            const LoadContext& context, Model& model);

}  // namespace walkcycle
