#include <string>
#include <vector>

#include "ProfileCase.h"

namespace walkcycle {
namespace {

void expectGltf(const std::vector<Change>& changes, const char* code, const std::string& marker,
                const char* pathEnd) {
    expectSaid(Profile::Gltf, changed(changes), code, marker, pathEnd);
}

const std::string kFiveJoints = "<vcount>5 1 2 1</vcount>\n<v>0 0 1 0 0 1 1 1 0 2 0 0 0 1 1 1 1 0</v>";

TEST(GltfRulesTest, aFifthJointOfAVertexNeedsASecondSet) {
    expectGltf({{"<vcount>1 1 2 1</vcount>", kFiveJoints}, {"          <v>0 0 0 0 0 1 1 1 1 0</v>\n", ""}},
               "WC1001", "<vertex_weights", "skin/vertex_weights");
}

TEST(GltfRulesTest, aJointWithoutWeightDoesNotCount) {
    const std::string text = changed({{"<vcount>1 1 2 1</vcount>", kFiveJoints},
                                      {"          <v>0 0 0 0 0 1 1 1 1 0</v>\n", ""},
                                      {">1 0.5 0.25<", ">1 0.5 0<"}});
    EXPECT_THAT(said(Profile::Gltf, text), testing::IsEmpty());
}

TEST(GltfRulesTest, curvesAreSampledAnew) {
    expectGltf({{">LINEAR LINEAR<", ">BEZIER LINEAR<"}}, "WC1002", "mPelvis-kinds-array",
               "Name_array[id=mPelvis-kinds-array]");
}

TEST(GltfRulesTest, aShearedNodeIsNoTranslationRotationAndScale) {
    expectGltf({{"<node id=\"body\" name=\"body\" type=\"NODE\">",
                 "<node id=\"body\" name=\"body\" type=\"NODE\">\n<matrix>1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 "
                 "1</matrix>"}},
               "WC1003", "<node id=\"body\"", "node[id=body]");
}

TEST(GltfRulesTest, animatedShearIsTold) {
    expectGltf({{"1 0 0 0.25 0 1 0 0 0 0 1 0.5 0 0 0 1", "1 1 0 0.25 0 1 0 0 0 0 1 0.5 0 0 0 1"}}, "WC1004",
               "<node id=\"mTorso\"", "node[id=mTorso]");
}

TEST(GltfRulesTest, polygonsBecomeTriangles) {
    expectGltf({{"count=\"2\">\n          <input semantic=\"VERTEX\"",
                 "count=\"1\">\n          <input semantic=\"VERTEX\""},
                {"<vcount>3 3</vcount>", "<vcount>4</vcount>"},
                {"<p>0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3</p>", "<p>0 0 0 1 0 1 2 0 2 3 0 3</p>"}},
               "WC1005", "<polylist", "mesh/polylist");
}

std::string light(const std::string& kind) {
    return "<library_lights><light id=\"lamp\"><technique_common>\n<" + kind + "><color>1 1 1</color></" +
           kind + ">\n</technique_common></light></library_lights>\n  <library_effects>";
}
const Change kLampNode{kSceneEnd, inScene("<node id=\"lampnode\"><instance_light url=\"#lamp\"/></node>\n")};

TEST(GltfRulesTest, ambientLightIsLost) {
    expectGltf({{"  <library_effects>", light("ambient")}, kLampNode}, "WC1006", "<light id",
               "light[id=lamp]");
}

TEST(GltfRulesTest, otherLightsAreAnExtension) {
    expectGltf({{"  <library_effects>", light("point")}, kLampNode}, "WC1007", "<light id", "light[id=lamp]");
}

TEST(GltfRulesTest, aColourCannotBeAnimated) {
    expectGltf(
        {{"  <library_effects>", light("point")},
         kLampNode,
         {"target=\"mTorso/transform\"/>",
          "target=\"mTorso/transform\"/>\n<channel source=\"#mTorso-sampler\" target=\"lamp/color.R\"/>"},
         {"<color>1 1 1</color>", "<color sid=\"color\">1 1 1</color>"}},
        "WC1008", "target=\"lamp/color.R\"", "animation[id=mTorso-move]/channel");
}

std::string picture(const std::string& file, const std::string& slot, const std::string& sampler = "") {
    return "<newparam sid=\"map-surface\"><surface "
           "type=\"2D\"><init_from>map</init_from></surface></newparam>\n"
           "<newparam sid=\"map-sampler\"><sampler2D><source>map-surface</source>" +
           sampler + "</sampler2D></newparam>\n<technique sid=\"common\">\n<phong>\n" + slot +
           "</phong>\n</technique></profile_COMMON></effect></library_effects>\n<library_images>\n"
           "<image id=\"map\"><init_from>" +
           file +
           "</init_from></image></library_images>\n<library_effects>"
           "<effect id=\"unused\"><profile_COMMON>\n        <technique sid=\"common\">";
}
const std::string kTechnique = "        <technique sid=\"common\">";
const std::string kTexture = "<texture texture=\"map-sampler\" texcoord=\"map\"/>";

TEST(GltfRulesTest, aTargaPictureMustBeConverted) {
    expectGltf({{kTechnique, picture("skin.tga", "<diffuse>" + kTexture + "</diffuse>\n")}}, "WC1009",
               "skin.tga", "image[id=map]/init_from");
}

TEST(GltfRulesTest, aPngPictureIsFine) {
    EXPECT_THAT(said(Profile::Gltf,
                     changed({{kTechnique, picture("skin.PNG", "<diffuse>" + kTexture + "</diffuse>\n")}})),
                testing::IsEmpty());
}

TEST(GltfRulesTest, aBorderIsNotThere) {
    expectGltf({{kTechnique,
                 picture("skin.png", "<diffuse>" + kTexture + "</diffuse>\n", "\n<wrap_s>BORDER</wrap_s>")}},
               "WC1010", "<wrap_s>", "sampler2D/wrap_s");
}

TEST(GltfRulesTest, aSpecularPictureHasNoPlace) {
    expectGltf({{kTechnique, picture("skin.png", "<specular>\n" + kTexture + "</specular>\n")}}, "WC1011",
               kTexture, "specular/texture");
}

TEST(GltfRulesTest, aMaskOfItsOwnMustBecomeAlpha) {
    expectGltf({{kTechnique, picture("skin.png", "<diffuse><color>1 1 1 1</color></diffuse><transparent>\n" +
                                                     kTexture + "</transparent>\n")}},
               "WC1012", kTexture, "transparent/texture");
}

TEST(GltfRulesTest, aCameraNeedsItsVerticalAngle) {
    const std::string camera =
        "<library_cameras>\n<camera id=\"eye\"><optics><technique_common><perspective><xfov>40</xfov>"
        "<znear>0.1</znear><zfar>9</zfar></perspective></technique_common></optics></camera></"
        "library_cameras>\n"
        "  <library_effects>";
    expectGltf({{"  <library_effects>", camera},
                {kSceneEnd, inScene("<node id=\"eyenode\"><instance_camera url=\"#eye\"/></node>\n")}},
               "WC1013", "<camera id", "camera[id=eye]");
}

// A <morph> of the body and `count` copies of it.
std::string morph(const std::string& source, int count) {
    std::string names, weights;
    for (int i = 0; i < count; ++i) {
        names += "body-mesh ";
        weights += "0 ";
    }
    const std::string n = std::to_string(count);
    return "<controller id=\"face\">\n<morph source=\"#" + source +
           "\" method=\"NORMALIZED\">\n<source id=\"mt\"><IDREF_array id=\"mta\" count=\"" + n + "\">" +
           names + "</IDREF_array><technique_common><accessor source=\"#mta\" count=\"" + n +
           "\"><param name=\"MORPH_TARGET\" type=\"IDREF\"/></accessor></technique_common></source>\n"
           "<source id=\"mw\"><float_array id=\"mwa\" count=\"" +
           n + "\">" + weights + "</float_array><technique_common><accessor source=\"#mwa\" count=\"" + n +
           "\"><param name=\"MORPH_WEIGHT\" "
           "type=\"float\"/></accessor></technique_common></source>\n<targets>"
           "<input semantic=\"MORPH_TARGET\" source=\"#mt\"/><input semantic=\"MORPH_WEIGHT\" "
           "source=\"#mw\"/>"
           "</targets></morph></controller>\n    <controller id=\"body-skin\"";
}

TEST(GltfRulesTest, aMorphOverASkinIsTheWrongWayRound) {
    expectGltf({{"    <controller id=\"body-skin\"", morph("body-skin", 1)},
                {"<instance_controller url=\"#body-skin\">", "<instance_controller url=\"#face\">"}},
               "WC1014", "<instance_controller", "node[id=body]/instance_controller");
}

TEST(GltfRulesTest, manyMorphTargetsAreMoreThanViewersMustShow) {
    expectGltf({{"    <controller id=\"body-skin\"", morph("body-mesh", 9)},
                {"<skin source=\"#body-mesh\">", "<skin source=\"#face\">"}},
               "WC1015", "<morph source", "controller[id=face]/morph");
}

TEST(GltfRulesTest, aThirdSetOfTextureCoordinatesMayBeLeftOut) {
    std::string copies, inputs;
    for (const char* id : {"b", "c"}) {
        copies += std::string("<source id=\"map-") + id + "\"><float_array id=\"map-" + id +
                  "a\" count=\"2\">0 0</float_array><technique_common><accessor source=\"#map-" + id +
                  "a\" count=\"1\" stride=\"2\"><param name=\"S\" type=\"float\"/><param name=\"T\" "
                  "type=\"float\"/>"
                  "</accessor></technique_common></source>";
        inputs += std::string("<input semantic=\"TEXCOORD\" source=\"#map-") + id + "\" offset=\"1\" set=\"" +
                  (*id == 'b' ? "1" : "2") + "\"/>";
    }
    expectGltf({{"        <vertices id", copies + "\n        <vertices id"},
                {"          <vcount>3 3</vcount>", inputs + "\n          <vcount>3 3</vcount>"}},
               "WC1016", "<polylist", "mesh/polylist");
}

TEST(GltfRulesTest, physicsStayBehind) {
    expectGltf({{"    <instance_visual_scene",
                 "    <instance_physics_scene url=\"#p\"/>\n    <instance_visual_scene"}},
               "WC1017", "<instance_physics_scene", "scene/instance_physics_scene");
}

}  // namespace
}  // namespace walkcycle
