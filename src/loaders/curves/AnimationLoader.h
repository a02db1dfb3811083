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

// What a document says about motion, exactly: its curves at work, and the clips that it cuts them into.
struct LoadedMotion {
    std::shared_ptr<const Motion> motion;  // null where nothing moves
    std::vector<ClipRange> clips;
};

// Reads every <animation> and <animation_clip> of the root document, and what they move. Appends to model.parameters. All
// else of the model must be loaded; AnimationFitter makes key frames of the result.
LoadedMotion loadAnimations(XmlNode collada, const SceneGraph& scene, const AnimationTargets& targets,
                            const LoadContext& context, Model& model);

}  // namespace walkcycle
