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

// The axis that points up in a document's space (COLLADA 1.4.1, chapter 5, <up_axis>).
enum class UpAxis { X, Y, Z };

// The document's <asset> (COLLADA 1.4.1, chapter 5). Unit and axis are those of the meshes, key frames and
// bind matrices, also if model transforms are converted (see Model). Values that LoadOptions replaces are the
// replacements.
struct Asset {
    std::string version;        // of the COLLADA schema: "1.4.1"
    std::string authoringTool;  // of the first <contributor>; empty if there is none
    std::string unitName = "meter";
    double metersPerUnit = 1.0;  // positive
    UpAxis upAxis = UpAxis::Y;
};

// One step of deforming a mesh: a <controller> with a <morph> or <skin>.
struct Deformer {
    enum class Kind { Morph, Skin };
    Kind kind = Kind::Skin;
    int index = 0;       // into Model::morphs or Model::skins
    int influences = 0;  // Skin: index into Model::influences
};

// The material of one part of an instance, and the texture coordinates of its textures.
struct PartMaterial {
    int material = -1;  // index into Model::materials; -1: none is bound
    // Per Slot: index into MeshData::texCoordSets; -1 if the slot has no texture.
    std::array<int, kSlotCount> texCoordSets{};
};

// A drawn <instance_geometry> or <instance_controller>: a mesh at a node of the scene.
struct MeshInstance {
    int node = 0;                         // index into Skeleton::joints
    int mesh = 0;                         // index into Model::meshes
    std::string sourceUrl;                // its `url`: "#body-skin"
    std::vector<Deformer> deformers;      // innermost first; empty for a rigid mesh
    std::vector<PartMaterial> materials;  // one per entry of MeshData::parts
};

// The kind of a Parameter, and what its `object` and `component` mean.
enum class ParameterKind {
    MorphWeight,    // object: Model::morphs, component: target
    CameraValue,    // object: Model::cameras, component: CameraComponent
    LightColor,     // object: Model::lights, component: 0 r, 1 g, 2 b
    LightValue,     // object: Model::lights, component: LightComponent
    MaterialColor,  // object: Model::materials, component: slot * 4 + channel
    MaterialValue,  // object: Model::materials, component: MaterialComponent
    NodeVisible     // object: Skeleton::joints
};
// The animated numbers of a SceneCamera. Units as there: angles in degrees, distances in the document's unit.
enum class CameraComponent { XFov, YFov, XMag, YMag, Aspect, ZNear, ZFar };
// The animated numbers of a SceneLight. The angle is in degrees.
enum class LightComponent {
    Intensity,
    ConstantAttenuation,
    LinearAttenuation,
    QuadraticAttenuation,
    FalloffAngle,
    FalloffExponent
};
// The animated numbers of a Material.
enum class MaterialComponent { Shininess, Reflectivity, Transparency, IndexOfRefraction };

// A number of the model that animations may change and that belongs to no joint transform. Every morph weight
// is one; other numbers are one if a channel of the file targets them.
struct Parameter {
    ParameterKind kind = ParameterKind::MorphWeight;
    int object = 0;          // index into the vector that ParameterKind names
    int component = 0;       // which number of the object: see ParameterKind
    float restValue = 0.0f;  // the value while no animation moves it
};

// Thrown by Model::animation() if no clip has the name. what() lists the names of all clips.
struct WALKCYCLE_API NoSuchClip : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The contents of a file as plain data: no XML, no OpenGL.
//
// Spaces: meshes, key frames and bind matrices are in the document's own axes and unit (Asset). Model
// transforms, and all that they place, are in metres with Y up: Skeleton::rootTransform converts, unless
// LoadOptions::convert was off. Times are seconds of the document's timeline. All indices are valid: a
// reference to a missing element is reported, and its owner left out. All numbers are finite.
struct WALKCYCLE_API Model {
    std::string file;  // as the caller named it
    Asset asset;
    std::string sceneId;                  // of the <visual_scene> that is shown; empty if it has no id
    Skeleton skeleton;                    // every node of the scene, parents first
    std::vector<bool> nodeVisible;        // one per joint, at rest; a hidden node hides its children, too
    std::vector<MeshData> meshes;         // each drawn mesh once
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
    // [0] is the whole timeline, named after the file; the clips of the file (<animation_clip>) follow. Empty
    // if nothing is animated.
    std::vector<Animation> animations;
    std::vector<Diagnostic> diagnostics;  // the faults of the file, in the order in which they were found
    std::shared_ptr<const ExactMotion>
        exactMotion;  // the curves of animations[0]; null if nothing is animated

    // The rest value of each of `parameters`.
    std::vector<float> restParameters() const;

    // The first of `animations` with this name. Throws NoSuchClip if there is none.
    const Animation& animation(std::string_view name) const&;
    // That of a temporary model is a copy, so that no Animator can keep a pointer into it:
    // animator.doAnimation(loadCollada(path).animation("walk")) does not compile.
    Animation animation(std::string_view name) &&;
};

// Thrown by borrowClips() if no clip of the source can move the model. what() says why.
struct WALKCYCLE_API NothingToBorrow : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The clips of `source`, bound to the joints of `model`: for animations that are exported without their
// character. A channel moves the joint of `model` whose id, name or sid equals the id, name or sid of its own
// joint; ids are compared first. Channels without such a joint are left out, and so are morph weights,
// cameras, lights and materials. Distances are scaled from the unit of `source` to that of `model`. Axes are
// not converted: both documents must have the same up axis.
//
// Append the result to Model::animations, or play it with an Animator of the model; the Animator must not
// outlive it. Throws NothingToBorrow if `source` has no animation, or if `model` has none of the joints that
// it moves.
WALKCYCLE_API std::vector<Animation> borrowClips(const Model& source, const Model& model);

}  // namespace walkcycle
