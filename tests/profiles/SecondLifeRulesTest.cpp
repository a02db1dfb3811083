#include <string>
#include <vector>

#include "ProfileCase.h"
#include "profiles/SecondLifeJoints.h"

namespace walkcycle {
namespace {

void expectSl(const std::vector<Change>& changes, const char* code, const std::string& marker,
              const char* pathEnd) {
    expectSaid(Profile::SecondLife, changed(changes), code, marker, pathEnd);
}

const std::string kBindShape =
    "        <bind_shape_matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>\n";
std::string rock(const std::string& transform) {
    return inScene("<node id=\"rock\" name=\"rock\">" + transform +
                   "\n<instance_geometry url=\"#body-mesh\"/></node>\n");
}

TEST(SecondLifeRulesTest, theSkeletonHasBonesVolumesAliasesAndAttachments) {
    for (const char* name : {"mPelvis", "mFaceEyecornerInnerLeft", "mHindLimb4Right", "LEFT_PEC", "hip",
                             "avatar_mTorso", "Left_Shoulder", "Nose"})
        EXPECT_TRUE(isSecondLifeJoint(name)) << name;
    for (const char* name : {"Hips", "mpelvis", "Bone", "avatar_LEFT_PEC", "mixamorig:Hips", ""})
        EXPECT_FALSE(isSecondLifeJoint(name)) << name;
}

TEST(SecondLifeRulesTest, anUnknownJointCostsTheSkin) {
    expectSl(
        {{"id=\"mTorso\" name=\"mTorso\" sid=\"mTorso\"", "id=\"mTorso\" name=\"mTorso\" sid=\"Bone_7\""},
         {"mPelvis mTorso</Name_array>", "mPelvis Bone_7</Name_array>"}},
        "WC1050", "<Name_array id=\"body-joints-array\"", "Name_array[id=body-joints-array]");
}

TEST(SecondLifeRulesTest, moreThanAHundredAndTenJointsCostTheSkin) {
    std::string names = "mPelvis mTorso";
    for (int i = 2; i < 111; ++i) names += " mPelvis";
    expectSl({{"count=\"2\">mPelvis mTorso<", "count=\"111\">" + names + "<"},
              {"<accessor source=\"#body-joints-array\" count=\"2\"",
               "<accessor source=\"#body-joints-array\" count=\"111\""}},
             "WC1051", "<Name_array id=\"body-joints-array\"", "Name_array[id=body-joints-array]");
}

TEST(SecondLifeRulesTest, onlyFourJointsOfAVertexAreKept) {
    expectSl({{"<vcount>1 1 2 1</vcount>", "<vcount>5 1 2 1</vcount>"},
              {"<v>0 0 0 0 0 1 1 1 1 0</v>", "<v>0 0 1 0 0 1 1 1 0 2 0 0 0 1 1 1 1 0</v>"}},
             "WC1052", "<vertex_weights", "skin/vertex_weights");
}

TEST(SecondLifeRulesTest, weightsAndPositionsMustBeAsMany) {
    expectSl({{"<vertex_weights count=\"4\">", "<vertex_weights count=\"3\">"},
              {"<vcount>1 1 2 1</vcount>", "<vcount>1 1 2</vcount>"},
              {"<v>0 0 0 0 0 1 1 1 1 0</v>", "<v>0 0 0 0 0 1 1 1</v>"}},
             "WC1053", "<vertex_weights", "skin/vertex_weights");
}

TEST(SecondLifeRulesTest, aMorphIsNotRead) {
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
    expectSl({{"    <controller id=\"body-skin\"", morph},
              {"<instance_controller url=\"#body-skin\"", "<instance_controller url=\"#face\""}},
             "WC1054", "<morph source", "controller[id=face]/morph");
}

TEST(SecondLifeRulesTest, fansAreNotRead) {
    const std::string fan =
        "<trifans count=\"1\"><input semantic=\"VERTEX\" source=\"#body-vertices\" offset=\"0\"/>"
        "<p>0 1 2</p></trifans>\n";
    expectSl({{"        <polylist", fan + "        <polylist"}}, "WC1055", "<trifans", "mesh/trifans");
}

TEST(SecondLifeRulesTest, theNinthPartBecomesASecondObject) {
    std::string parts;
    for (int i = 0; i < 8; ++i)
        parts +=
            "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#body-vertices\" offset=\"0\"/><p>0 "
            "1 2</p></triangles>\n";
    expectSl({{"        <polylist", parts + "        <polylist"}}, "WC1056", "<mesh>",
             "geometry[id=body-mesh]/mesh");
}

TEST(SecondLifeRulesTest, aLongPolylistIsSplitIntoFaces) {
    std::string counts, indices;
    for (int i = 0; i < 8 * 21844 + 1; ++i) {
        counts += "3 ";
        indices += "0 0 0 1 0 1 2 0 2 ";
    }
    expectSl({{"<vcount>3 3</vcount>", "<vcount>" + counts + "</vcount>"},
              {"<p>0 0 0 1 0 1 2 0 2 0 0 0 2 0 2 3 0 3</p>", "<p>" + indices + "</p>"}},
             "WC1056", "<mesh>", "geometry[id=body-mesh]/mesh");
}

// A <triangles> of so many different corners, all in one line.
std::string manyCorners(int count) {
    std::string numbers, indices;
    for (int i = 0; i < count; ++i) {
        numbers += std::to_string(i) + " 0 " + std::to_string(i % 7) + " ";
        indices += std::to_string(i) + " ";
    }
    return "<source id=\"many\"><float_array id=\"manya\" count=\"" + std::to_string(3 * count) + "\">" +
           numbers + "</float_array><technique_common><accessor source=\"#manya\" count=\"" +
           std::to_string(count) +
           "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param "
           "name=\"Z\" type=\"float\"/>"
           "</accessor></technique_common></source><vertices id=\"manyv\"><input semantic=\"POSITION\" "
           "source=\"#many\"/></vertices>\n"
           "<triangles count=\"" +
           std::to_string(count / 3) + "\"><input semantic=\"VERTEX\" source=\"#manyv\" offset=\"0\"/><p>" +
           indices + "</p></triangles></mesh></geometry>\n";
}
const std::string kGeometry = "    <geometry id=\"body-mesh\"";
std::vector<Change> withCorners(int count) {
    return {{kGeometry, "<geometry id=\"big\"><mesh>\n" + manyCorners(count) + kGeometry},
            {kSceneEnd, inScene("<node id=\"b\"><instance_geometry url=\"#big\"/></node>\n")}};
}

TEST(SecondLifeRulesTest, indicesHaveSixteenBits) {
    expectSl(withCorners(65535), "WC1057", "<triangles", "geometry[id=big]/mesh/triangles");
}

TEST(SecondLifeRulesTest, oneCornerFewerFits) {
    for (const Diagnostic& diagnostic : said(Profile::SecondLife, changed(withCorners(65532))))
        EXPECT_EQ(diagnostic.code, "WC1063") << toString(diagnostic);
}

TEST(SecondLifeRulesTest, textureCoordinatesOfThreeNumbersAreMisread) {
    expectSl({{"count=\"8\">0 0 1 0 1 1 0 1<", "count=\"12\">0 0 0 1 0 0 1 1 0 0 1 0<"},
              {"count=\"4\" stride=\"2\"", "count=\"4\" stride=\"3\""},
              {"<param name=\"T\" type=\"float\"/>",
               "<param name=\"T\" type=\"float\"/><param name=\"P\" type=\"float\"/>"}},
             "WC1058", "<accessor source=\"#body-map-array\"",
             "source[id=body-map]/technique_common/accessor");
}

TEST(SecondLifeRulesTest, oneSetOfTextureCoordinatesIsUsed) {
    expectSl({{"          <vcount>3 3</vcount>",
               "<input semantic=\"TEXCOORD\" source=\"#body-map\" offset=\"2\" set=\"1\"/>\n          "
               "<vcount>3 3</vcount>"}},
             "WC1059", "<polylist", "mesh/polylist");
}

TEST(SecondLifeRulesTest, aMirroringMatrixIsRefused) {
    expectSl({{kSceneEnd, rock("<matrix>-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>")}}, "WC1060",
             "<instance_geometry", "node[id=rock]/instance_geometry");
}

TEST(SecondLifeRulesTest, aNegativeScaleLosesItsSign) {
    expectSl({{kSceneEnd, rock("\n<scale>-1 1 1</scale>")}}, "WC1061", "<scale>", "node[id=rock]/scale");
}

TEST(SecondLifeRulesTest, skewsAreIgnored) {
    expectSl({{kSceneEnd, rock("\n<skew>20 1 0 0 0 1 0</skew>")}}, "WC1062", "<skew>", "node[id=rock]/skew");
}

TEST(SecondLifeRulesTest, animationsComeFromOtherFiles) {
    expectSl({}, "WC1063", "<library_animations>", "COLLADA/library_animations");
}

TEST(SecondLifeRulesTest, otherMapsAreSetInTheViewer) {
    expectSl({{kLambert, "<phong><specular>\n<texture texture=\"map\" texcoord=\"uv\"/></specular></phong>"}},
             "WC1064", "<texture ", "specular/texture");
}

TEST(SecondLifeRulesTest, aTiffPictureIsNotRead) {
    expectSl({{"  <library_effects>",
               "<library_images>\n<image id=\"map\"><init_from>skin.tif</init_from></image>"
               "</library_images>\n  <library_effects>"}},
             "WC1065", "<init_from>", "image[id=map]/init_from");
}

TEST(SecondLifeRulesTest, aSkinNeedsItsBindShape) {
    expectSl({{kBindShape, ""}}, "WC1066", "<skin source", "controller[id=body-skin]/skin");
}

}  // namespace
}  // namespace walkcycle
