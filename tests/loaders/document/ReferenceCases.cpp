#include <string>
#include <vector>

#include "loaders/CodeCases.h"

namespace walkcycle {
namespace {

const std::string kScene = "COLLADA/library_visual_scenes/visual_scene[id=scene]/";
const std::string kSource = "COLLADA/library_geometries/geometry[id=mesh]/mesh/source[id=p]/";

// A source "p" of three positions, with another array or another accessor.
std::string positionsOf(const std::string& array, const std::string& accessor) {
    return showing(
        "<library_geometries><geometry id='mesh'><mesh>\n<source id='p'>\n" + array +
        "\n<technique_common>\n" + accessor +
        "\n</technique_common></source>\n"
        "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>\n"
        "<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles>\n"
        "</mesh></geometry></library_geometries>\n");
}

const std::string kArray = "<float_array id='a' count='9'>0 0 0 1 0 0 0 1 0</float_array>";
const std::string kAccessor = "<accessor source='#a' count='3' stride='3'/>";

std::string lit(const std::string& color) {
    return collada("<library_lights><light id='sun'><technique_common><directional>\n" + color +
                   "\n</directional></technique_common></light></library_lights>\n" +
                   scene("<node id='n'><instance_light url='#sun'/></node>"));
}

}  // namespace

std::vector<CodeCase> referenceCases() {
    LoadOptions noOtherFile;
    noOtherFile.resolver = files({});
    return {
        {Code::UnresolvedReference, collada(scene("<node id='n'>\n@<instance_geometry url='#gone'/></node>")),
         kScene + "node[id=n]/instance_geometry"},
        {Code::MissingAttribute,
         positionsOf("@<float_array id='a'>0 0 0 1 0 0 0 1 0</float_array>", kAccessor),
         kSource + "float_array[id=a]"},
        {Code::MissingElement, showing("<library_geometries>\n@<geometry id='mesh'/></library_geometries>\n"),
         "COLLADA/library_geometries/geometry[id=mesh]"},
        {Code::NumberInvalid,
         positionsOf("<float_array id='a' count='9'>0 0 0\n1 0 0\n0 @nan 0</float_array>", kAccessor),
         kSource + "float_array[id=a]"},
        {Code::CountMismatch,
         positionsOf("@<float_array id='a' count='8'>0 0 0 1 0 0 0 1 0</float_array>", kAccessor),
         kSource + "float_array[id=a]"},
        {Code::ReferenceLoop,
         collada(scene("<node id='n'>\n<node id='m'>\n@<instance_node url='#n'/></node></node>")),
         kScene + "node[id=n]/node[id=m]/instance_node"},
        {Code::WrongElement, collada(scene("<node id='n'>\n@<instance_geometry url='#n'/></node>")),
         kScene + "node[id=n]/instance_geometry"},
        {.code = Code::ExternalRefused,
         .document = collada(scene("<node id='n'>\n@<instance_geometry url='../../other.dae#mesh'/></node>")),
         .path = kScene + "node[id=n]/instance_geometry",
         .isOnDisk = true},
        {Code::ExternalMissing,
         collada(scene("<node id='n'>\n@<instance_geometry url='other.dae#mesh'/></node>")),
         kScene + "node[id=n]/instance_geometry", noOtherFile},
        {Code::NumberOddWarning, lit("<color>1\n@one\n1</color>"),
         "COLLADA/library_lights/light[id=sun]/technique_common/directional/color"},
        {Code::AccessorOutside, positionsOf(kArray, "@<accessor source='#a' count='4' stride='3'/>"),
         kSource + "technique_common/accessor"},
        {Code::ElementUnknown, meshOf("@<trinagles count='1'/>\n"),
         "COLLADA/library_geometries/geometry[id=mesh]/mesh/trinagles"},
        {Code::ElementRepeated,
         meshOf("<polylist count='1'><input semantic='VERTEX' source='#v' offset='0'/>\n<vcount>3</vcount>\n"
                "@<vcount>4</vcount><p>0 1 2</p></polylist>\n"),
         "COLLADA/library_geometries/geometry[id=mesh]/mesh/polylist/vcount"},
    };
}

}  // namespace walkcycle
