#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace walkcycle {

enum class LightKind { Ambient, Directional, Point, Spot };

// A <light> of the file. Directional and spot lights shine down their node's -Z. Distances are in document
// units.
struct SceneLight {
    std::string id, name;
    LightKind kind = LightKind::Directional;
    glm::vec3 color{1.0f};
    float intensity = 1.0f;  // of FCollada's <extra>; 1 where there is none
    float constantAttenuation = 1.0f, linearAttenuation = 0.0f, quadraticAttenuation = 0.0f;
    float falloffAngle = 180.0f;  // degrees, the full cone
    float falloffExponent = 0.0f;
};

// An <instance_light>.
struct LightInstance {
    int node = 0;   // index into Skeleton::joints
    int light = 0;  // index into Model::lights
};

}  // namespace walkcycle
