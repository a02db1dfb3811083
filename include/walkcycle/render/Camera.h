#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/animation/Joint.h>
#include <walkcycle/model/Bounds.h>
#include <walkcycle/model/CamerasAndLights.h>

namespace walkcycle {

// The side of the model on which Camera::framing() places the camera.
enum class CameraPreset {
    Auto,   // in front, a little to the side and above
    Front,  // +Z
    Side,   // +X
    Top,    // +Y
    Iso     // (1, 1, 1), in perspective
};

// The position, the direction and the lens of a camera, as two matrices. View space is OpenGL's: the camera looks along
// -Z, and +Y is up. `aspect` is the width of the picture divided by its height, as Framebuffer::aspect() gives it.
//
//     const Camera front = Camera::framing(model.bounds(), picture.aspect());  // shows all of the clip
//     const Camera side = Camera::framing(model.bounds(), picture.aspect(), CameraPreset::Side);
//     const Camera still = Camera::lookAt(position, focalPoint, up, 30.0f, picture.aspect(), model.bounds());
//
//     const CameraInstance& instance = model.model().cameraInstances.front();
//     const Camera own = Camera::ofScene(model.scene().cameras[instance.camera],
//                                        model.animator().modelTransforms()[instance.node],
//                                        model.model().skeleton, picture.aspect());
struct WALKCYCLE_API Camera {
    glm::mat4 view{1.0f};        // model space -> view space
    glm::mat4 projection{1.0f};  // view space -> clip space
    bool orthographic = false;

    glm::mat4 viewProjection() const { return projection * view; }  // model space -> clip space
    glm::vec3 position() const;                                     // in model space
    glm::vec3 direction() const;  // the viewing direction in model space, of unit length

    // The same camera whose pixels lie `pixels` further to the right and up, so that the model moves left and down in
    // the picture. The perspective does not change.
    Camera shifted(const glm::vec2& pixels, int pictureWidth, int pictureHeight) const;

    // A camera that shows all of the bounds, with a small margin. It stands on the side that `preset` names.
    static Camera framing(const Bounds& bounds, float aspect, CameraPreset preset = CameraPreset::Auto);

    // The same from any side: `towardsCamera` points from the bounds to the camera, at any length but 0.
    static Camera framingFrom(const Bounds& bounds, float aspect, const glm::vec3& towardsCamera,
                              const glm::vec3& up = {0.0f, 1.0f, 0.0f});

    // A camera at `position` that looks at `focalPoint`; both are in model space. The near and far planes enclose
    // `bounds`, so that nothing of it is cut off.
    static Camera lookAt(const glm::vec3& position, const glm::vec3& focalPoint, const glm::vec3& up,
                         float verticalFovDegrees, float aspect, const Bounds& bounds);

    // A camera of the file. `nodeTransform` is the model transform of the camera's node; the camera takes its position
    // and rotation, without scale, shear and mirroring. The distances of `camera` are in document units; the scale of
    // the skeleton's root transform converts them to metres. A width or height that the file leaves out follows from
    // `aspect`.
    static Camera ofScene(const SceneCamera& camera, const glm::mat4& nodeTransform, const Skeleton& skeleton,
                          float aspect);
};

// Metres per document unit: the scale of Skeleton::rootTransform; 1 if the load did not convert units.
WALKCYCLE_API float rootScale(const Skeleton& skeleton);

}  // namespace walkcycle
