#pragma once

#include <optional>
#include <string>

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

}  // namespace walkcycle
