#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "animation/Joint.h"
#include "model/CpuSkinning.h"
#include "model/SceneCamera.h"

namespace walkcycle {

enum class CameraPreset { Auto, Front, Side, Top, Iso };

// From where, and through which lens. View space is as OpenGL has it: the camera looks down -Z, +Y up.
//
//     Camera::framing(model.bounds(), picture.aspect())                       // all of the clip is in the
//     picture Camera::framing(model.bounds(), picture.aspect(), CameraPreset::Side)
//     Camera::ofScene(scene.cameras[i.camera], animator.modelTransforms()[i.node], skeleton,
//     picture.aspect()) Camera::lookAt(position, focalPoint, up, 30.0f, picture.aspect(), model.bounds())
struct Camera {
    glm::mat4 view{1.0f};
    glm::mat4 projection{1.0f};
    bool orthographic = false;

    glm::mat4 viewProjection() const { return projection * view; }
    glm::vec3 position() const;   // in model space
    glm::vec3 direction() const;  // where it looks, of unit length

    // The same view with the picture shifted by so many pixels to the left and down, as if the camera's film had moved.
    Camera shifted(const glm::vec2& pixels, int pictureWidth, int pictureHeight) const;

    // Shows all of the bounds, with a little room around them. +Z is the front.
    static Camera framing(const Bounds& bounds, float aspect, CameraPreset preset = CameraPreset::Auto);

    // The same from a direction (from the bounds towards the camera), for turntables and orbits.
    static Camera framingFrom(const Bounds& bounds, float aspect, const glm::vec3& towardsCamera,
                              const glm::vec3& up = {0.0f, 1.0f, 0.0f});

    // In metres, Y up. The near and far planes are put around `bounds`, so that nothing of it is cut off.
    static Camera lookAt(const glm::vec3& position, const glm::vec3& focalPoint, const glm::vec3& up,
                         float verticalFovDegrees, float aspect, const Bounds& bounds);

    // A camera of the file. Its view is the rigid part of its node's world transform; its distances are in
    // document units, which the skeleton's root transform turns into metres.
    static Camera ofScene(const SceneCamera& camera, const glm::mat4& nodeTransform, const Skeleton& skeleton,
                          float aspect);
};

// Metres per document unit: by how much the root transform makes things larger.
float rootScale(const Skeleton& skeleton);

}  // namespace walkcycle
