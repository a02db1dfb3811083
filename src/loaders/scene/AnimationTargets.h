#pragma once

#include <unordered_map>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The elements beside <node>s that an animation <channel> may target, and the index of the part of the Model
// that each became. The loaders of the parts fill the maps; the room curves reads them.
struct AnimationTargets {
    // <controller>, and the <source> and <float_array> of its weights -> Model::morphs
    std::unordered_map<XmlNode, int> morphs;
    std::unordered_map<XmlNode, int> cameras;         // <camera> -> Model::cameras
    std::unordered_map<XmlNode, int> lights;          // <light> -> Model::lights
    std::unordered_multimap<XmlNode, int> materials;  // <effect> and <material> -> Model::materials
};

}  // namespace walkcycle
