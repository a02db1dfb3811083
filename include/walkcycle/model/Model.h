#pragma once

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/animation/Animation.h>
#include <walkcycle/animation/Joint.h>
#include <walkcycle/animation/Skin.h>
#include <walkcycle/model/CamerasAndLights.h>
#include <walkcycle/model/Diagnostic.h>
#include <walkcycle/model/ExactMotion.h>
#include <walkcycle/model/Influences.h>
#include <walkcycle/model/Material.h>
#include <walkcycle/model/MeshData.h>
#include <walkcycle/model/MorphTargets.h>

namespace walkcycle {

// Which axis of a document's space points up (COLLADA 1.4.1, chapter 5, <up_axis>).
enum class UpAxis { X, Y, Z };

// The document's <asset>. Unit and axis are those of the vertex data and transforms, converted or not; what LoadOptions
// says instead of the document is here.
struct Asset {
    std::string version;        // of the COLLADA schema: "1.4.1"
    std::string authoringTool;  // of the first <contributor>; empty where it says nothing
    std::string unitName = "meter";
    double metersPerUnit = 1.0;  // over 0
    UpAxis upAxis = UpAxis::Y;
};

// One step of deforming a mesh: a <controller>.
struct Deformer {
    enum class Kind { Morph, Skin };
    Kind kind = Kind::Skin;
    int index = 0;       // into Model::morphs or Model::skins
    int influences = 0;  // Skin: index into Model::influences
};

// The material of one part of one instance, and which texture coordinates its pictures use.
struct PartMaterial {
    int material = -1;  // index into Model::materials; -1: none is bound
    // Per Slot: index into MeshData::texCoordSets; -1 where it has none.
    std::array<int, kSlotCount> texCoordSets{};
};

// An <instance_geometry> or <instance_controller> that is drawn.
struct MeshInstance {
    int node = 0;                         // index into Skeleton::joints
    int mesh = 0;                         // index into Model::meshes
    std::string sourceUrl;                // as the instance has it: "#body-skin"
    std::vector<Deformer> deformers;      // innermost first; empty for a rigid mesh
    std::vector<PartMaterial> materials;  // one per entry of MeshData::parts
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
// Of a SceneCamera: fields of view in degrees, magnifications and distances in the document's unit.
enum class CameraComponent { XFov, YFov, XMag, YMag, Aspect, ZNear, ZFar };
// Of a SceneLight: the angle in degrees.
enum class LightComponent {
    Intensity,
    ConstantAttenuation,
    LinearAttenuation,
    QuadraticAttenuation,
    FalloffAngle,
    FalloffExponent
};
// Of a Material.
enum class MaterialComponent { Shininess, Reflectivity, Transparency, IndexOfRefraction };

// A number of the model that animations may change and that is not part of a joint's transform: every morph
// weight, and those other numbers that a channel targets.
struct Parameter {
    ParameterKind kind = ParameterKind::MorphWeight;
    int object = 0;          // an index, into what ParameterKind says
    int component = 0;       // as ParameterKind says
    float restValue = 0.0f;  // the value while no animation moves it
};

// Thrown where a clip is asked for by a name that no clip has; what() lists those that there are.
struct WALKCYCLE_API NoSuchClip : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Everything that a file holds, as plain data: no XML, no OpenGL.
//
// Spaces: positions, key frames and bind matrices are in the document's own axes and unit (Asset). Model transforms, and
// with them all that is posed, are in metres with Y up, by Skeleton::rootTransform, unless LoadOptions::convert was off.
// Times are seconds of the document's timeline. Indices are valid: a file that refers to what is not there is reported,
// and what refers to it is left out. All numbers are finite.
struct WALKCYCLE_API Model {
    std::string file;  // as the caller named it
    Asset asset;
    std::string sceneId;                  // of the <visual_scene> that is shown; empty where it has none
    Skeleton skeleton;                    // every node of the scene, parents first
    std::vector<bool> nodeVisible;        // one per joint, at rest
    std::vector<MeshData> meshes;         // each that is drawn, once
    std::vector<MorphTargets> morphs;     // one per <morph>; its instances share it
    std::vector<Skin> skins;              // one per instance of a skin
    std::vector<Influences> influences;   // one per <skin>; its instances share it (see Deformer)
    std::vector<MeshInstance> instances;  // the <instance_geometry>s, then the <instance_controller>s
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<SceneCamera> cameras;
    std::vector<CameraInstance> cameraInstances;
    std::vector<SceneLight> lights;
    std::vector<LightInstance> lightInstances;
    std::vector<Parameter> parameters;
    // [0] is the whole timeline, named like the file; the file's own clips (<animation_clip>) follow. Empty where nothing
    // moves.
    std::vector<Animation> animations;
    std::vector<Diagnostic> diagnostics;  // what is wrong with the file, in the order in which it was met
    std::shared_ptr<const ExactMotion> exactMotion;  // the curves of animations[0]; null where nothing moves

    // The value at rest of each of `parameters`.
    std::vector<float> restParameters() const;

    // The first of `animations` that has this name. Throws NoSuchClip.
    const Animation& animation(std::string_view name) const;
};

// Thrown by borrowClips where there is nothing that could be played.
struct WALKCYCLE_API NothingToBorrow : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The clips of `source` as they move `model`: for animations that are exported apart from their character. A channel
// moves the joint of `model` whose id, name or sid is the id, name or sid of its own joint (ids are looked for first);
// channels without such a joint are left out, and so are morph weights, cameras, lights and materials, which each file has
// for itself. Distances are scaled from the unit of the one document to that of the other; axes are not turned: both
// documents must have the same up axis.
//
// The result can be put behind Model::animations, or played by an Animator of the model's skeleton that it outlives.
// Throws NothingToBorrow, saying which, where `source` has no animation or none of its moving joints is in `model`.
WALKCYCLE_API std::vector<Animation> borrowClips(const Model& source, const Model& model);

}  // namespace walkcycle
