#include <iterator>
#include <string>
#include <vector>

#include "ProfileCase.h"

namespace walkcycle {
namespace {

void expectGazebo(const std::vector<Change>& changes, const char* code, const std::string& marker,
                  const char* pathEnd) {
    expectSaid(Profile::Gazebo, changed(changes), code, marker, pathEnd);
}

const Change kAsPolygons[] = {
    {"<polylist", "<polygons"},
    {"          <vcount>3 3</vcount>\n", ""},
    {"<p>0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3</p>", "<p>0 0 0 1 0 1 2 0 2</p><p>0 0 0 2 0 2 3 0 3</p>"},
    {"</polylist>", "</polygons>"}};
const Change kAsTriangles[] = {
    {"<polylist", "<triangles"}, {"          <vcount>3 3</vcount>\n", ""}, {"</polylist>", "</triangles>"}};
const std::string kBindShape = "<bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>";
const std::string kRigid =
    "<node id=\"rock\" name=\"rock\">\n<instance_geometry url=\"#body-mesh\"/></node>\n";

// ---- geometry

TEST(GazeboRulesTest, polygonsAreNotRead) {
    expectGazebo({kAsPolygons, kAsPolygons + 4}, "WC1020", "<polygons", "mesh/polygons");
}

TEST(GazeboRulesTest, aConcavePolygonComesOutWrong) {
    expectGazebo(
        {{"0 0 0 1 0 0 1 0 1 0 0 1", "0 0 0 4 0 1 1 0 1 1 0 4"},  // an arrow head, seen from the first corner
         {"<vcount>3 3</vcount>", "<vcount>4</vcount>"},
         {"count=\"2\">\n          <input semantic=\"VERTEX\"",
          "count=\"1\">\n          <input semantic=\"VERTEX\""},
         {"<p>0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3</p>", "<p>1 0 1 2 0 2 3 0 3 0 0 0</p>"}},
        "WC1021", "<polylist", "mesh/polylist");
}

TEST(GazeboRulesTest, aConcavePolygonThatItsFanFillsIsFine) {
    const std::string text =
        changed({{"0 0 0 1 0 0 1 0 1 0 0 1", "0 0 0 4 0 1 1 0 1 1 0 4"},
                 {"<vcount>3 3</vcount>", "<vcount>4</vcount>"},
                 {"count=\"2\">\n          <input semantic=\"VERTEX\"",
                  "count=\"1\">\n          <input semantic=\"VERTEX\""},
                 {"<p>0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3</p>", "<p>0 0 0 1 0 1 2 0 2 3 0 3</p>"}});
    EXPECT_THAT(said(Profile::Gazebo, text), testing::IsEmpty());
}

TEST(GazeboRulesTest, inputsThatShareAnOffsetShiftAllIndices) {
    expectGazebo({{"source=\"#body-normals\" offset=\"1\"", "source=\"#body-normals\" offset=\"0\""},
                  {"source=\"#body-map\" offset=\"2\"", "source=\"#body-map\" offset=\"1\""},
                  {"0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3", "0 0 0 1 0 2 0 0 0 2 0 3"},
                  {"count=\"3\">0 -1 0<", "count=\"12\">0 -1 0 0 -1 0 0 -1 0 0 -1 0<"},
                  {"body-normals-array\" count=\"1\"", "body-normals-array\" count=\"4\""}},
                 "WC1032", "<polylist", "mesh/polylist");
}

TEST(GazeboRulesTest, aSourceNeedsItsStride) {
    expectGazebo({{"count=\"4\" stride=\"2\"", "count=\"4\""}}, "WC1033",
                 "<accessor source=\"#body-map-array\"", "source[id=body-map]/technique_common/accessor");
}

TEST(GazeboRulesTest, copiesOfAGeometryStandWhereTheFirstOneDoes) {
    expectGazebo(
        {{kSceneEnd, inScene(kRigid + "<node id=\"stone\" name=\"stone\"><translate>1 2 3</translate>\n"
                                      "<instance_geometry  url=\"#body-mesh\"/></node>\n")}},
        "WC1031", "<instance_geometry  url", "node[id=stone]/instance_geometry");
}

// ---- the scene

TEST(GazeboRulesTest, theUpAxisIsIgnored) {
    expectGazebo({{"Z_UP", "Y_UP"}}, "WC1035", "<up_axis>", "asset/up_axis");
}

TEST(GazeboRulesTest, aMissingUpAxisMeansY) {
    expectGazebo({{"    <up_axis>Z_UP</up_axis>\n", ""}}, "WC1035", "<asset>", "COLLADA/asset");
}

TEST(GazeboRulesTest, aSceneMustBeNamed) {
    expectGazebo({{"    <instance_visual_scene url=\"#scene\"/>\n", ""}}, "WC1036", "<COLLADA", "COLLADA");
}

TEST(GazeboRulesTest, twoNodesWithoutNamesHangIt) {
    expectGazebo({{kSceneEnd, inScene("<node id=\"outer\">\n<node id=\"inner\"/></node>\n")}}, "WC1037",
                 "<node id=\"inner\"", "node[id=outer]/node[id=inner]");
}

TEST(GazeboRulesTest, whatStandsBesideAnInstancedNodeIsLeftOut) {
    expectGazebo({{"  <library_visual_scenes>",
                   "<library_nodes><node id=\"tpl\" name=\"tpl\"/></library_nodes>\n"
                   "  <library_visual_scenes>"},
                  {kSceneEnd, inScene("<node id=\"pair\" name=\"pair\"><instance_node url=\"#tpl\"/>\n"
                                      "<instance_node  url=\"#tpl\"/></node>\n")}},
                 "WC1029", "<instance_node  url", "node[id=pair]/instance_node");
}

TEST(GazeboRulesTest, aPivotIsNotFollowed) {
    expectGazebo({{kSceneEnd, inScene("<node id=\"door\" name=\"door\"><translate>1 0 0</translate>"
                                      "<rotate>0 0 1 90</rotate><translate>-1 0 0</translate>"
                                      "<instance_geometry url=\"#body-mesh\"/></node>\n")}},
                 "WC1030", "<node id=\"door\"", "node[id=door]");
}

TEST(GazeboRulesTest, theUsualOrderOfTransformsIsFollowed) {
    const std::string text = changed(
        {{kSceneEnd,
          inScene("<node id=\"door\" name=\"door\" type=\"JOINT\"><translate>1 0 0</translate><rotate>0 0 1 "
                  "90</rotate><rotate>0 1 0 20</rotate><scale>2 1 1</scale></node>\n")}});
    EXPECT_THAT(said(Profile::Gazebo, text), testing::IsEmpty());
}

TEST(GazeboRulesTest, aCamerasPivotDoesNotMatter) {
    const std::string text =
        changed({{kSceneEnd, inScene("<node id=\"eye\" name=\"eye\"><lookat>1 2 3 0 0 0 0 0 1"
                                     "</lookat></node>\n")}});
    EXPECT_THAT(said(Profile::Gazebo, text), testing::IsEmpty());
}

TEST(GazeboRulesTest, camerasAreNotRead) {
    const std::string camera =
        "<library_cameras><camera "
        "id=\"eye\"><optics><technique_common><perspective><yfov>40</yfov><znear>0.1</znear>"
        "<zfar>9</zfar></perspective></technique_common></optics></camera></library_cameras>\n  "
        "<library_effects>";
    expectGazebo(
        {{"  <library_effects>", camera},
         {kSceneEnd, inScene("<node id=\"e\" name=\"e\">\n<instance_camera url=\"#eye\"/></node>\n")}},
        "WC1048", "<instance_camera", "node[id=e]/instance_camera");
}

TEST(GazeboRulesTest, aSidBeforeTheIdIsTakenForIt) {
    expectGazebo({{"<technique sid=\"common\">", "<technique sid=\"body-mesh\">"}}, "WC1034", "<skin source",
                 "controller[id=body-skin]/skin");
}

std::string effectWithPicture(const std::string& id, const std::string& image) {
    return "<effect id=\"" + id +
           "\"><profile_COMMON>\n<newparam sid=\"surface\"><surface type=\"2D\"><init_from>" + image +
           "</init_from></surface></newparam><newparam "
           "sid=\"sampler\"><sampler2D><source>surface</source></sampler2D>"
           "</newparam><technique sid=\"common\"><lambert><diffuse>\n<texture texture=\"sampler\" "
           "texcoord=\"" +
           id + "\"/></diffuse></lambert></technique></profile_COMMON></effect>\n";
}
const std::string kImages =
    "<library_images><image id=\"a\"><init_from>a.png</init_from></image><image "
    "id=\"b\"><init_from>b.png</init_from>"
    "</image></library_images>\n  <library_effects>\n";

TEST(GazeboRulesTest, aSamplerOfAnotherEffectIsTakenForOneOfItsName) {
    expectGazebo({{"  <library_effects>\n",
                   kImages + effectWithPicture("first", "a") + effectWithPicture("second", "b")}},
                 "WC1034", "texcoord=\"second\"", "diffuse/texture");
}

TEST(GazeboRulesTest, samplersOfOneNameForOnePictureAreFine) {
    const std::string text = changed({{"  <library_effects>\n", kImages + effectWithPicture("first", "a") +
                                                                    effectWithPicture("second", "a")}});
    EXPECT_THAT(said(Profile::Gazebo, text), testing::IsEmpty());
}

// ---- skins

TEST(GazeboRulesTest, aMorphIsNotRead) {
    const std::string morph =
        "<controller id=\"face\">\n<morph source=\"#body-mesh\"><source id=\"mt\"><IDREF_array id=\"mta\" "
        "count=\"1\">"
        "body-mesh</IDREF_array><technique_common><accessor source=\"#mta\" "
        "count=\"1\"/></technique_common></source>"
        "<source id=\"mw\"><float_array id=\"mwa\" count=\"1\">0</float_array><technique_common><accessor "
        "source=\"#mwa\" "
        "count=\"1\"/></technique_common></source><targets><input semantic=\"MORPH_TARGET\" "
        "source=\"#mt\"/><input "
        "semantic=\"MORPH_WEIGHT\" source=\"#mw\"/></targets></morph></controller>\n    <controller "
        "id=\"body-skin\"";
    expectGazebo({{"    <controller id=\"body-skin\"", morph},
                  {"<skin source=\"#body-mesh\"", "<skin source=\"#face\""}},
                 "WC1022", "<morph source", "controller[id=face]/morph");
}

TEST(GazeboRulesTest, aSkinNeedsItsBindShape) {
    expectGazebo({{"        " + kBindShape + "\n", ""}}, "WC1023", "<skin source",
                 "controller[id=body-skin]/skin");
}

TEST(GazeboRulesTest, jointsByIdAreNotRead) {
    expectGazebo({{"<Name_array id=\"body-joints-array\"", "<IDREF_array id=\"body-joints-array\""},
                  {"mPelvis mTorso</Name_array>", "mPelvis mTorso</IDREF_array>"}},
                 "WC1024", "<source id=\"body-joints\"", "source[id=body-joints]");
}

TEST(GazeboRulesTest, aJointIsCalledByItsSidFirst) {
    expectGazebo(
        {{"id=\"mTorso\" name=\"mTorso\" sid=\"mTorso\"", "id=\"mTorso\" name=\"mTorso\" sid=\"Bone_001\""}},
        "WC1025", "<Name_array id=\"body-joints-array\"", "Name_array[id=body-joints-array]");
}

TEST(GazeboRulesTest, weightsMustBePairs) {
    expectGazebo({{"source=\"#body-joints\" offset=\"0\"", "source=\"#body-joints\" offset=\"1\""},
                  {"source=\"#body-weights\" offset=\"1\"", "source=\"#body-weights\" offset=\"2\""},
                  {"<v>0 0 0 0 0 1 1 1 1 0</v>", "<v>9 0 0 9 0 0 9 0 1 9 1 1 9 1 0</v>"}},
                 "WC1026", "<vertex_weights", "skin/vertex_weights");
}

TEST(GazeboRulesTest, aBindShapeIsNotAppliedToTriangles) {
    std::vector<Change> changes(std::begin(kAsTriangles), std::end(kAsTriangles));
    changes.push_back({kBindShape, "<bind_shape_matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>"});
    expectGazebo(changes, "WC1027", "<bind_shape_matrix>", "skin/bind_shape_matrix");
}

TEST(GazeboRulesTest, theSkinsNodeMovesItToo) {
    expectGazebo({{"<node id=\"body\" name=\"body\" type=\"NODE\">",
                   "<node id=\"body\" name=\"body\" type=\"NODE\"><translate>0 0 1</translate>"}},
                 "WC1028", "<instance_controller", "node[id=body]/instance_controller");
}

}  // namespace
}  // namespace walkcycle
