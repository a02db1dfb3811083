#include <optional>
#include <string>
#include <vector>

#include "loaders/CodeCases.h"
#include "walkcycle/io/File.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

const std::string kInstance =
    "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=n]/instance_geometry";
const std::string kBinding = kInstance + "/bind_material/technique_common/instance_material";
const std::string kEffect = "COLLADA/library_effects/effect[id=e]";
const std::string kTechnique = kEffect + "/profile_COMMON/technique[sid=t]";
const std::string kLambert = kTechnique + "/lambert/";
const std::string kImage = "COLLADA/library_images/image[id=i]";
const std::string kBind = "<instance_material symbol='paint' target='#m'/>";
const std::string kUvInput = "<input semantic='TEXCOORD' source='#uv' offset='0' set='0'/>\n";

// A triangle that asks for the material "paint", and what an instance binds to it.
std::string triangleBinding(const std::string& libraries, const std::string& binding,
                            const std::string& uvInput = kUvInput) {
    return collada(
        libraries + "<library_geometries><geometry id='mesh'><mesh>\n" +
        floatSource("p", "0 0 0 1 0 0 0 1 0") + floatSource("uv", "0 0 1 0 0 1", "ST") +
        "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>\n"
        "<triangles count='1' material='paint'><input semantic='VERTEX' source='#v' offset='0'/>\n" +
        uvInput + "<p>0 1 2</p></triangles>\n</mesh></geometry></library_geometries>\n" +
        scene("<node id='n'>\n<instance_geometry url='#mesh'>\n" + binding + "</instance_geometry></node>"));
}

std::string bound(const std::string& instanceMaterial) {
    return "<bind_material><technique_common>\n" + instanceMaterial + "\n</technique_common></bind_material>";
}

std::string library(const std::string& material) {
    return "<library_materials>\n" + material + "</library_materials>\n";
}

const std::string kMaterial = library("<material id='m'><instance_effect url='#e'/></material>\n");

// The material "paint" is of the effect "e".
std::string withEffect(const std::string& effect, const std::string& images = "") {
    return kMaterial + images + "<library_effects>\n" + effect + "</library_effects>\n";
}

std::string effectOf(const std::string& lambert, const std::string& parameters = "") {
    return "<effect id='e'><profile_COMMON>\n" + parameters + "<technique sid='t'><lambert>\n" + lambert +
           "</lambert></technique></profile_COMMON></effect>\n";
}

std::string painted(const std::string& lambert, const std::string& parameters = "",
                    const std::string& images = "") {
    return triangleBinding(withEffect(effectOf(lambert, parameters), images), bound(kBind));
}

const std::string kTexture = "<diffuse><texture texture='sampler' texcoord='uv'/></diffuse>\n";
const std::string kSampler =
    "<newparam sid='surface'><surface type='2D'><init_from>i</init_from></surface></newparam>\n"
    "<newparam sid='sampler'><sampler2D><source>surface</source></sampler2D></newparam>\n";

std::string imageAt(const std::string& path) {
    return "<library_images><image id='i'>\n@<init_from>" + path + "</init_from></image></library_images>\n";
}

std::string pictured(const std::string& path) {
    return painted(kTexture, kSampler, imageAt(path));
}

LoadOptions beside(const std::string& name, const std::string& bytes) {
    LoadOptions options;
    options.resolver = files({{name, bytes}});
    return options;
}

LoadOptions tooWide() {
    const Bytes png = encodePng({.width = 20, .height = 1, .hasAlpha = false, .rgba = Bytes(80, 255)});
    LoadOptions options = beside("skin.png", {png.begin(), png.end()});
    options.limits.maxImageDimension = 19;
    return options;
}

LoadOptions brokenDisk() {
    LoadOptions options;
    options.resolver = [](const std::string&) -> std::optional<Bytes> {
        throw FileError("the disk is broken");
    };
    return options;
}

std::vector<CodeCase> effectCases() {
    return {
        {Code::EffectNotThere,
         triangleBinding(library("<material id='m'>\n@<instance_effect url='#gone'/></material>\n"),
                         bound(kBind)),
         "COLLADA/library_materials/material[id=m]/instance_effect"},
        {Code::EffectUnusable,
         triangleBinding(
             withEffect("<effect id='e'><profile_COMMON>\n@<technique sid='t'/></profile_COMMON></effect>\n"),
             bound(kBind)),
         kTechnique},
        {Code::ParameterNotThere, painted("<diffuse>\n@<param ref='gone'/></diffuse>\n"),
         kLambert + "diffuse/param"},
        {Code::ColorNumbers, painted("<diffuse>\n@<color>1 0</color></diffuse>\n"),
         kLambert + "diffuse/color"},
        {Code::TextureUnresolved, painted("<diffuse>\n@<texture texture='gone' texcoord='uv'/></diffuse>\n"),
         kLambert + "diffuse/texture"},
        {Code::TextureNamesImage,
         painted("<diffuse>\n@<texture texture='i' texcoord='uv'/></diffuse>\n", "",
                 "<library_images><image id='i'><init_from>a.png</init_from></image></library_images>\n"),
         kLambert + "diffuse/texture"},
        {Code::WordUnknown, painted("@<transparent opaque='A_NONE'><color>1 1 1 1</color></transparent>\n"),
         kLambert + "transparent"},
        {Code::TransparencyInverted, painted("@<transparency><float>0</float></transparency>\n"),
         kLambert + "transparency"},
    };
}

std::vector<CodeCase> pictureCases() {
    return {
        {Code::PictureMissing, pictured("skin.png"), kImage + "/init_from", beside("none", "")},
        {Code::PictureGuessed, pictured("/home/anna/skin.png"), kImage + "/init_from",
         beside("skin.png", "")},
        {Code::PictureBroken, pictured("skin.png"), kImage + "/init_from", beside("skin.png", "no picture")},
        {Code::PictureOverLimit, pictured("skin.png"), kImage + "/init_from", tooWide()},
        {Code::PictureRemote, pictured("http://example.org/skin.png"), kImage + "/init_from",
         beside("none", "")},
        {Code::PictureUnreadable, pictured("skin.png"), kImage + "/init_from", brokenDisk()},
        {Code::ImageEmpty, pictured(""), kImage + "/init_from"},
    };
}

}  // namespace

std::vector<CodeCase> materialCases() {
    const std::string twoSets =
        "<instance_material symbol='paint' target='#m'>\n@<bind_vertex_input semantic='uv' "
        "input_semantic='TEXCOORD' input_set='7'/></instance_material>";
    const std::string images =
        "<library_images><image id='i'><init_from>a.png</init_from></image></library_images>\n";
    std::vector<CodeCase> cases = {
        {Code::MaterialNotThere,
         triangleBinding("", bound("@<instance_material symbol='paint' target='#gone'/>")), kBinding},
        {Code::MaterialUnbound, damagedAt(triangleBinding("", ""), "<instance_geometry"), kInstance},
        {Code::MaterialGuessed,
         damagedAt(triangleBinding(library("<material id='paint'><instance_effect url='#e'/></material>\n") +
                                       "<library_effects>\n" + effectOf("") + "</library_effects>\n",
                                   ""),
                   "<instance_geometry"),
         kInstance},
        {Code::TexCoordsGuessed,
         triangleBinding(withEffect(effectOf(kTexture, kSampler), images), bound(twoSets)),
         kBinding + "/bind_vertex_input"},
        {Code::TexCoordsMissing,
         triangleBinding(withEffect(effectOf(kTexture, kSampler), images), bound("@" + kBind), ""), kBinding},
    };
    for (const auto& more : {effectCases(), pictureCases()})
        cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}  // namespace walkcycle
