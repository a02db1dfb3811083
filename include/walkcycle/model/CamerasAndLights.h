#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace walkcycle {

// A <camera> of the file: its optics, in the document's units and degrees. It looks down its node's -Z, +Y
// up. Of each pair (xfov, yfov) and (xmag, ymag) one or both may be given; aspect is width / height.
struct SceneCamera {
    std::string id, name;
    bool orthographic = false;
    std::optional<double> xfov, yfov;  // full angles in degrees
    std::optional<double> xmag, ymag;  // half widths and heights
    std::optional<double> aspect;
    double znear = 0.1, zfar = 1000.0;
};

// An <instance_camera>.
struct CameraInstance {
    int node = 0;    // index into Skeleton::joints
    int camera = 0;  // index into Model::cameras
};

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
