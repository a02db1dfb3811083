#pragma once

#include "loaders/context/LoadContext.h"
#include "loaders/scene/SceneGraph.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// A document and the model that was made of it, for rules about things that the model does not keep: which elements a part
// came from, at which offsets, in which order. It exists during the call of LoadOptions::inspector. Findings go to
// context.diagnostics, and from there to Model::diagnostics.
struct Inspection {
    XmlNode collada;
    const SceneGraph& scene;
    const Model& model;
    const LoadContext& context;
};

}  // namespace walkcycle
