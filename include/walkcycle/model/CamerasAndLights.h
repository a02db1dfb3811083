#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace walkcycle {

// The optics of a <camera> (COLLADA 1.4.1, chapter 5, <perspective> and <orthographic>). The camera looks
// along the -Z axis of its node, with +Y up. Distances are in the document's unit.
struct SceneCamera {
    std::string id, name;
    bool orthographic = false;
    // Perspective: the full angle of view, horizontal and vertical, in degrees. At least one is given.
    std::optional<double> xfov, yfov;
    // Orthographic: half the width and half the height of the view. At least one is given.
    std::optional<double> xmag, ymag;
    std::optional<double> aspect;       // width / height; empty if the file does not say
    double znear = 0.1, zfar = 1000.0;  // distances of the clipping planes
};

// An <instance_camera>: a camera at a node of the scene.
struct CameraInstance {
    int node = 0;    // index into Skeleton::joints
    int camera = 0;  // index into Model::cameras
};

// The elements of a <light>: <ambient>, <directional>, <point>, <spot>.
enum class LightKind { Ambient, Directional, Point, Spot };

// A <light> (COLLADA 1.4.1, chapter 5). Directional lights and spots shine along the -Z axis of their node.
// Points and spots are attenuated: at distance d, in the document's unit, by 1 / (constant + linear * d +
// quadratic * d * d).
struct SceneLight {
    std::string id, name;
    LightKind kind = LightKind::Directional;
    glm::vec3 color{1.0f};   // red, green, blue, as in the file
    float intensity = 1.0f;  // multiplies the colour; always 1 at rest, but an animation may change it
    float constantAttenuation = 1.0f, linearAttenuation = 0.0f, quadraticAttenuation = 0.0f;
    float falloffAngle = 180.0f;   // spots: full angle of the cone, in degrees
    float falloffExponent = 0.0f;  // spots: 0 is an evenly lit cone; larger values fade towards its edge
};

// An <instance_light>: a light at a node of the scene.
struct LightInstance {
    int node = 0;   // index into Skeleton::joints
    int light = 0;  // index into Model::lights
};

}  // namespace walkcycle
