#pragma once

#include <unordered_map>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// What a channel may target beside nodes: which element became which part of the Model. The loaders fill it, and
// AnimationLoader reads it.
struct AnimationTargets {
    std::unordered_map<XmlNode, int>
        morphs;  // <controller>, its weights' <source> and <float_array> -> Model::morphs
    std::unordered_map<XmlNode, int> cameras;         // <camera> -> Model::cameras
    std::unordered_map<XmlNode, int> lights;          // <light> -> Model::lights
    std::unordered_multimap<XmlNode, int> materials;  // <effect> and <material> -> Model::materials
};

}  // namespace walkcycle
