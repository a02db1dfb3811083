#pragma once

#include "loaders/AnimationLoader.h"
#include "loaders/LoadContext.h"
#include "loaders/XmlNode.h"
#include "model/Model.h"

namespace walkcycle {

// Makes the key frames that play as the file's curves do, within LoadOptions::tolerance: fills model.animations (the whole
// timeline first, then each clip) and sets model.exactMotion.
void fitAnimations(const LoadedMotion& loaded, XmlNode collada, const LoadContext& context, Model& model);

}  // namespace walkcycle
