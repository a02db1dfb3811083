#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <walkcycle/Export.h>
#include <walkcycle/animation/Joint.h>
#include <walkcycle/model/Bounds.h>
#include <walkcycle/model/CamerasAndLights.h>

namespace walkcycle {

enum class CameraPreset { Auto, Front, Side, Top, Iso };

// Where a picture is taken from, and through which lens. In view space the camera looks down -Z, with +Y up,
// as in OpenGL.
//
//     Camera::framing(model.bounds(), picture.aspect());  // shows all of the clip
//     Camera::framing(model.bounds(), picture.aspect(), CameraPreset::Side);
//     Camera::ofScene(scene.cameras[i.camera], animator.modelTransforms()[i.node], skeleton, picture.aspect());
//     Camera::lookAt(position, focalPoint, up, 30.0f, picture.aspect(), model.bounds());
struct WALKCYCLE_API Camera {
    glm::mat4 view{1.0f};
    glm::mat4 projection{1.0f};
    bool orthographic = false;

    glm::mat4 viewProjection() const { return projection * view; }
    glm::vec3 position() const;   // in model space
    glm::vec3 direction() const;  // where it looks, of unit length

    // The same camera, with the picture moved left and down by so many pixels, and without a change of
    // perspective.
    Camera shifted(const glm::vec2& pixels, int pictureWidth, int pictureHeight) const;

    // A camera that shows all of the bounds, with a small margin. Front is the side of +Z.
    static Camera framing(const Bounds& bounds, float aspect, CameraPreset preset = CameraPreset::Auto);

    // The same, seen from any side: `towardsCamera` points from the bounds to the camera.
    static Camera framingFrom(const Bounds& bounds, float aspect, const glm::vec3& towardsCamera,
                              const glm::vec3& up = {0.0f, 1.0f, 0.0f});

    // In metres, Y up. The near and far planes enclose `bounds`, so that nothing of it is cut off.
    static Camera lookAt(const glm::vec3& position, const glm::vec3& focalPoint, const glm::vec3& up,
                         float verticalFovDegrees, float aspect, const Bounds& bounds);

    // A camera of the file. Its view is the rigid part of its node's model transform. Its distances are in
    // document units, which the scale of the skeleton's root transform converts to metres.
    static Camera ofScene(const SceneCamera& camera, const glm::mat4& nodeTransform, const Skeleton& skeleton,
                          float aspect);
};

// Metres per document unit: the scale of the root transform.
WALKCYCLE_API float rootScale(const Skeleton& skeleton);

}  // namespace walkcycle
