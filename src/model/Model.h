#pragma once

#include <memory>
#include <string>
#include <vector>

#include "animation/Animation.h"
#include "animation/Joint.h"
#include "animation/Skin.h"
#include "model/Diagnostic.h"
#include "model/ExactMotion.h"
#include "model/Influences.h"
#include "model/Material.h"
#include "model/MeshData.h"
#include "model/MorphTargets.h"
#include "model/SceneCamera.h"
#include "model/SceneLight.h"

namespace walkcycle {

enum class UpAxis { X, Y, Z };

struct Asset {
    std::string version;  // of the COLLADA schema: "1.4.1"
    std::string authoringTool;
    std::string unitName = "meter";
    double metersPerUnit = 1.0;
    UpAxis upAxis = UpAxis::Y;
};

// One step of deforming a mesh.
struct Deformer {
    enum class Kind { Morph, Skin };
    Kind kind = Kind::Skin;
    int index = 0;       // into Model::morphs or Model::skins
    int influences = 0;  // Skin: index into Model::influences
};

// The material of one part of one instance, and which texture coordinates its pictures use.
struct PartMaterial {
    int material = -1;  // index into Model::materials; -1: none is bound
    std::array<int, kSlotCount>
        texCoordSets{};  // per Slot: index into MeshData::texCoordSets, -1 where it has none
};

// An <instance_geometry> or <instance_controller> that is drawn.
struct MeshInstance {
    int node = 0;                         // index into Skeleton::joints
    int mesh = 0;                         // index into Model::meshes
    std::string sourceUrl;                // as the instance has it: "#body-skin"
    std::vector<Deformer> deformers;      // innermost first; empty for a rigid mesh
    std::vector<PartMaterial> materials;  // one per MeshData::parts
};

// What a Parameter belongs to. `object` and `component` say which number of it.
enum class ParameterKind {
    MorphWeight,    // object: Model::morphs, component: target
    CameraValue,    // object: Model::cameras, component: CameraComponent
    LightColor,     // object: Model::lights, component: 0 r, 1 g, 2 b
    LightValue,     // object: Model::lights, component: LightComponent
    MaterialColor,  // object: Model::materials, component: slot * 4 + channel
    MaterialValue,  // object: Model::materials, component: MaterialComponent
    NodeVisible     // object: Skeleton::joints
};
enum class CameraComponent { XFov, YFov, XMag, YMag, Aspect, ZNear, ZFar };
enum class LightComponent {
    Intensity,
    ConstantAttenuation,
    LinearAttenuation,
    QuadraticAttenuation,
    FalloffAngle,
    FalloffExponent
};
enum class MaterialComponent { Shininess, Reflectivity, Transparency, IndexOfRefraction };

// A number of the model that animations may change and that is not part of a joint's transform: every morph
// weight, and those other numbers that a channel targets.
struct Parameter {
    ParameterKind kind = ParameterKind::MorphWeight;
    int object = 0;
    int component = 0;
    float restValue = 0.0f;
};

// Everything that a file holds, as plain data: no XML, no OpenGL.
struct Model {
    std::string file;  // as the user named it
    Asset asset;
    std::string sceneId;
    Skeleton skeleton;
    std::vector<bool> nodeVisible;  // per joint, at rest
    std::vector<MeshData> meshes;
    std::vector<MorphTargets> morphs;
    std::vector<Skin> skins;  // one per instance of a skin
    std::vector<Influences> influences;
    std::vector<MeshInstance> instances;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<SceneCamera> cameras;
    std::vector<CameraInstance> cameraInstances;
    std::vector<SceneLight> lights;
    std::vector<LightInstance> lightInstances;
    std::vector<Parameter> parameters;
    std::vector<Animation>
        animations;  // [0] is the whole timeline; the file's own clips follow. Empty: nothing moves
    std::vector<Diagnostic> diagnostics;
    std::shared_ptr<const ExactMotion> exactMotion;  // null where nothing moves

    std::vector<float> restParameters() const;
};

}  // namespace walkcycle
