#pragma once

#include "loaders/context/LoadContext.h"
#include "loaders/curves/AnimationLoader.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Makes the key frames that play as the file's curves do, within LoadOptions::tolerance: fills model.animations (the whole
// timeline first, then each clip) and sets model.exactMotion.
void fitAnimations(const LoadedMotion& loaded, XmlNode collada, const LoadContext& context, Model& model);

}  // namespace walkcycle
