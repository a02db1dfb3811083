#pragma once

#include "loaders/context/LoadContext.h"
#include "loaders/curves/AnimationLoader.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Makes key frames that follow the curves of the file within LoadOptions::tolerance. Fills model.animations
// (the whole timeline, then each clip), and sets model.exactMotion.
void fitAnimations(const LoadedMotion& loaded, XmlNode collada, const LoadContext& context, Model& model);

}  // namespace walkcycle
