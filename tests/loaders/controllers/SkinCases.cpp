#include <cstddef>
#include <string>
#include <vector>

#include "loaders/CodeCases.h"

namespace walkcycle {
namespace {

const std::string kController = "COLLADA/library_controllers/controller[id=skin]";
const std::string kSkin = kController + "/skin/";
const std::string kBinds = matrixSource("binds", kIdentity + kIdentity);

std::string skinned(const std::string& controller, const std::string& instance = "",
                    const std::string& more = "") {
    return collada(
        more + triangle() + controllers(controller) +
        scene("<node id='hip' sid='hip' type='JOINT'><node id='knee' sid='knee' type='JOINT'/></node>\n"
              "<node id='body' name='Body'><translate>1 0 0</translate>\n"
              "<instance_controller url='#skin'>\n" +
              instance + "</instance_controller>\n</node>"));
}

std::string skinWith(SkinText skin) {
    if (skin.inverseBinds.empty()) skin.inverseBinds = kBinds;
    return skinned(skin.text());
}

std::string morphed(const std::string& weights, const std::string& target) {
    return skinned("<controller id='skin'><morph source='#mesh'>\n" +
                       nameSource("names", "smile", "IDREF_array") + floatSource("weights", weights, "W") +
                       "<targets>\n<input semantic='MORPH_TARGET' source='#names'/>\n"
                       "<input semantic='MORPH_WEIGHT' source='#weights'/></targets></morph></controller>\n",
                   "", target);
}

std::string otherJointList() {
    std::string document =
        skinWith({.joints = nameSource("joints", "hip knee") + nameSource("others", "hip knee")});
    const std::size_t weights = document.find("<vertex_weights");
    document.replace(document.find("#joints", weights), 7, "#others");
    return document.insert(weights, "@");
}

std::string byMaya(std::string document) {
    return document.insert(document.find("<unit"),
                           "<contributor><authoring_tool>ColladaMaya v2</authoring_tool></contributor>");
}

}  // namespace

std::vector<CodeCase> skinCases() {
    const std::string joints = kSkin + "source[id=joints]/Name_array[id=joints-array]";
    const std::string noBinds = skinned(SkinText{}.text());
    return {
        {Code::JointNotFound, skinWith({.joints = nameSource("joints", "hip\n@gone")}), joints},
        {Code::WeightsNotNormalised, skinWith({.vcount = "1 1 1", .v = "0 0\n@1 2\n1 0"}),
         kSkin + "vertex_weights/v"},
        {Code::UnweightedVertices, skinWith({.vcount = "1\n@0\n1", .v = "0 0 1 0"}),
         kSkin + "vertex_weights/vcount"},
        {Code::JointMatrixMismatch,
         damagedAt(skinWith({.inverseBinds = matrixSource("binds", kIdentity)}), "<joints>"),
         kSkin + "joints"},
        {Code::InverseBindMissing, damagedAt(noBinds, "<joints>"), kSkin + "joints"},
        {Code::SkinNodeApplied, damagedAt(byMaya(skinWith({})), "<instance_controller"),
         "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=body]/instance_controller"},
        {Code::DuplicateJoint, skinWith({.joints = nameSource("joints", "hip\n@hip")}), joints},
        {Code::NegativeWeight,
         skinWith({.weights = floatSource("weights", "1\n@-0.5\n0.25", "W"), .v = "0 0 1 0 1 1"}),
         kSkin + "source[id=weights]/float_array[id=weights-array]"},
        {Code::InfluenceOutOfRange, skinWith({.v = "0 0\n1 0\n@5 0"}), kSkin + "vertex_weights/v"},
        {Code::WeightsShorterThanMesh,
         damagedAt(skinWith({.positions = 2, .vcount = "1 1", .v = "0 0 1 0"}), "<vertex_weights"),
         kSkin + "vertex_weights"},
        {Code::SingularBindMatrix,
         skinWith({.inverseBinds = matrixSource("binds", kIdentity + "\n@0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1")}),
         kSkin + "source[id=binds]/float_array[id=binds-array]"},
        {Code::WeightSetIgnored,
         skinWith({.weightInputs = "@<input semantic=\"WEIGHT\" source=\"#weights\" offset=\"1\"/>\n"}),
         kSkin + "vertex_weights/input"},
        {Code::SkeletonNotFound,
         skinned(SkinText{.inverseBinds = kBinds}.text(), "@<skeleton>#gone</skeleton>\n"),
         "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=body]/instance_controller/skeleton"},
        {Code::ControllerEmpty, skinned("@<controller id='skin'/>\n"), kController},
        {Code::MorphTargetsMismatch, damagedAt(morphed("0 0", triangle("smile")), "<targets>"),
         kController + "/morph/targets"},
        {Code::JointListsDiffer, otherJointList(), kSkin + "vertex_weights"},
        {Code::MorphTargetShort,
         damagedAt(morphed("0", triangle("smile", "0 0 0 1 0 0")), "<geometry id=\"smile\""),
         "COLLADA/library_geometries/geometry[id=smile]"},
    };
}

}  // namespace walkcycle
