#include <string>
#include <vector>

#include "loaders/CodeCases.h"

namespace walkcycle {
namespace {

const std::string kNode = "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=n]";

std::string nodeWith(const std::string& transform) {
    return collada(scene("<node id='n'>\n" + transform + "\n</node>"));
}

// Two scenes, and what says which to show.
std::string twoScenes(const std::string& choice) {
    return "<?xml version='1.0'?>\n<COLLADA version='1.4.1'>\n<library_visual_scenes>\n"
           "<visual_scene id='day'/>\n<visual_scene id='night'/>\n</library_visual_scenes>\n" +
           choice + "\n</COLLADA>";
}

}  // namespace

std::vector<CodeCase> sceneCases() {
    LoadOptions dusk, fewElements, stopped;
    dusk.scene = "dusk";
    fewElements.limits.maxElements = 5;
    stopped.cancelled = [] { return true; };
    const std::string camera =
        "<library_cameras><camera id='lens'><optics><technique_common>\n@<perspective>\n"
        "<znear>1</znear></perspective></technique_common></optics></camera></library_cameras>\n";
    const std::string light =
        "<library_lights><light id='lamp'>\n@<technique_common>\n<area/></technique_common></light>"
        "</library_lights>\n";
    return {
        {Code::NoScene, "<COLLADA version='1.4.1'>\n<asset/>\n@<scene/>\n</COLLADA>", "COLLADA/scene"},
        {Code::SceneGuessed, damagedAt(twoScenes(""), "<COLLADA"), "COLLADA"},
        {Code::SceneNotFound, damagedAt(twoScenes(""), "<COLLADA"), "COLLADA", dusk},
        {Code::OpticsMissing, collada(camera + scene("<node id='n'><instance_camera url='#lens'/></node>")),
         "COLLADA/library_cameras/camera[id=lens]/optics/technique_common/perspective"},
        {Code::LightKindUnknown, collada(light + scene("<node id='n'><instance_light url='#lamp'/></node>")),
         "COLLADA/library_lights/light[id=lamp]/technique_common"},
        {Code::TransformNumbers, nodeWith("@<translate>1 2</translate>"), kNode + "/translate"},
        {Code::DegenerateTransform, nodeWith("@<rotate>0 0 0 90</rotate>"), kNode + "/rotate"},
        {Code::TransformOverflow, damagedAt(nodeWith("<scale>1e20 1 1</scale>"), "<node id='n'>"), kNode},
        {Code::LimitExceeded,
         "<COLLADA version='1.4.1'>\n<asset/>\n<scene/>\n<extra/>\n<extra/>\n@<extra/>\n</COLLADA>", "",
         fewElements},
        {Code::Cancelled, nodeWith(""), "", stopped},
    };
}

}  // namespace walkcycle
