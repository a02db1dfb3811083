#include <cstddef>
#include <string>
#include <vector>

#include "ProfileCase.h"

namespace walkcycle {
namespace {

void expectTm(const std::vector<Change>& changes, const char* code, const std::string& marker,
              const char* pathEnd) {
    expectSaid(Profile::ThinMatrix, changed(changes), code, marker, pathEnd);
}

const std::string kTorso = "<node id=\"mTorso\" name=\"mTorso\" sid=\"mTorso\" type=\"JOINT\">";

// ---- joints

TEST(ThinMatrixMotionRulesTest, jointsMustBeInANameArray) {
    expectTm({{"<Name_array id=\"body-joints-array\"", "<IDREF_array id=\"body-joints-array\""},
              {"mPelvis mTorso</Name_array>", "mPelvis mTorso</IDREF_array>"}},
             "WC1081", "<source id=\"body-joints\"", "source[id=body-joints]");
}

TEST(ThinMatrixMotionRulesTest, theArmatureIsFoundByItsId) {
    expectTm({{"<node id=\"Armature\"", "<node id=\"Rig\""}}, "WC1082", "<visual_scene id",
             "visual_scene[id=scene]");
}

TEST(ThinMatrixMotionRulesTest, jointsAreFoundByNodeId) {
    expectTm({{kTorso, "<node id=\"Armature_mTorso\" name=\"mTorso\" sid=\"mTorso\" type=\"JOINT\">"},
              {"target=\"mTorso/transform\"", "target=\"Armature_mTorso/transform\""}},
             "WC1083", "<node id=\"Armature_mTorso\"", "node[id=Armature_mTorso]");
}

TEST(ThinMatrixMotionRulesTest, aJointNeedsItsMatrix) {
    expectTm({{"<matrix sid=\"transform\">1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1</matrix>",
               "<translate>0 0 0.5</translate>"}},
             "WC1084", kTorso, "node[id=mTorso]");
}

TEST(ThinMatrixMotionRulesTest, theShaderHasRoomForFiftyJoints) {
    std::string more;
    for (int i = 0; i < 49; ++i)
        more += "<node id=\"b" + std::to_string(i) +
                "\">\n<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>\n</node>\n";
    expectTm({{kTorso, more + kTorso}}, "WC1085", "<node id=\"mPelvis\"", "node[id=mPelvis]");
}

TEST(ThinMatrixMotionRulesTest, theArmaturesTransformIsIgnored) {
    expectTm({{"name=\"Armature\" type=\"NODE\">", "name=\"Armature\" type=\"NODE\">\n<scale>2 2 2</scale>"}},
             "WC1087", "<node id=\"Armature\"", "node[id=Armature]");
}

TEST(ThinMatrixMotionRulesTest, theRestPoseIsTakenForTheBindPose) {
    expectTm({{"0 1 -0.5 0 0 0 1</float_array>", "0 1 -0.75 0 0 0 1</float_array>"}}, "WC1088", kTorso,
             "node[id=mTorso]");
}

// ---- animations

TEST(ThinMatrixMotionRulesTest, anAnimationMustBeThere) {
    const std::string text = cleanDocument();
    const std::size_t begin = text.find("<library_animations>"), end = text.find("</library_animations>");
    expectSaid(Profile::ThinMatrix, text.substr(0, begin) + "<library_animations>\n  " + text.substr(end),
               "WC1089", "<library_animations>", "COLLADA/library_animations");
}

TEST(ThinMatrixMotionRulesTest, nestedAnimationsAreNotLookedInto) {
    expectTm({{"    <animation id=\"mTorso-move\">",
               "    <animation id=\"outer\">\n<animation id=\"mTorso-move\">"},
              {"target=\"mTorso/transform\"/>\n    </animation>",
               "target=\"mTorso/transform\"/>\n    </animation>\n</animation>"}},
             "WC1090", "<animation id=\"outer\"", "animation[id=outer]");
}

TEST(ThinMatrixMotionRulesTest, allKeyTimesAreThoseOfTheFirstAnimation) {
    expectTm({{"<float_array id=\"mTorso-times-array\" count=\"2\">0 1<",
               "<float_array id=\"mTorso-times-array\" count=\"2\">0 2<"}},
             "WC1091", "<source id=\"mTorso-times\"", "source[id=mTorso-times]");
}

TEST(ThinMatrixMotionRulesTest, everyValueIsTakenForAMatrix) {
    expectTm({{"<matrix sid=\"transform\">1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1</matrix>",
               "<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>\n<translate sid=\"transform\">0 0 "
               "0.5</translate>"},
              {"<float_array id=\"mTorso-values-array\" count=\"32\">1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1 1 0 0 "
               "0.25 0 1 0 0 0 0 1 0.5 0 0 0 1<",
               "<float_array id=\"mTorso-values-array\" count=\"6\">0 0 0.5 0 0 1<"},
              {"<accessor source=\"#mTorso-values-array\" count=\"2\" stride=\"16\">",
               "<accessor source=\"#mTorso-values-array\" count=\"2\" stride=\"3\">"}},
             "WC1092", "<source id=\"mTorso-values\"", "source[id=mTorso-values]");
}

TEST(ThinMatrixMotionRulesTest, everyJointMustMove) {
    expectTm({{"target=\"mTorso/transform\"", "target=\"mPelvis/transform\""}}, "WC1093", kTorso,
             "node[id=mTorso]");
}

TEST(ThinMatrixMotionRulesTest, curvesBecomeStraight) {
    expectTm({{">LINEAR LINEAR<", ">STEP STEP<"}}, "WC1094", "mPelvis-kinds-array",
             "Name_array[id=mPelvis-kinds-array]");
}

TEST(ThinMatrixMotionRulesTest, animatedScaleIsLost) {
    expectTm({{"1 0 0 0.25 0 1 0 0", "2 0 0 0.25 0 2 0 0"}}, "WC1095", "<source id=\"mTorso-values\"",
             "source[id=mTorso-values]");
}

TEST(ThinMatrixMotionRulesTest, oneKeyIsTooFew) {
    expectTm({{"<float_array id=\"mPelvis-times-array\" count=\"2\">0 1<",
               "<float_array id=\"mPelvis-times-array\" count=\"1\">0<"}},
             "WC1098", "<float_array id=\"mPelvis-times-array\"", "float_array[id=mPelvis-times-array]");
}

TEST(ThinMatrixMotionRulesTest, aLateFirstKeyIsRunPast) {
    expectTm({{"<float_array id=\"mPelvis-times-array\" count=\"2\">0 1<",
               "<float_array id=\"mPelvis-times-array\" count=\"2\">0.04 1<"}},
             "WC1099", "<float_array id=\"mPelvis-times-array\"", "float_array[id=mPelvis-times-array]");
}

}  // namespace
}  // namespace walkcycle
