#include <cstddef>
#include <string>
#include <vector>

#include "ProfileCase.h"

namespace walkcycle {
namespace {

void expectGazebo(const std::vector<Change>& changes, const char* code, const std::string& marker,
                  const char* pathEnd) {
    expectSaid(Profile::Gazebo, changed(changes), code, marker, pathEnd);
}

const std::string kTorsoChannel = "<channel source=\"#mTorso-sampler\" target=\"mTorso/transform\"/>";
const Change kNoInstance = {"<instance_controller url=\"#body-skin\">",
                            "<instance_geometry url=\"#body-mesh\">"};

TEST(GazeboMotionRulesTest, curvesBecomeStraight) {
    expectGazebo({{">LINEAR LINEAR<", ">LINEAR STEP<"}}, "WC1038", "mPelvis-kinds-array",
                 "Name_array[id=mPelvis-kinds-array]");
}

TEST(GazeboMotionRulesTest, anAnimatedTranslationStandsStill) {
    expectGazebo({{"<matrix sid=\"transform\">1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1</matrix>",
                   "<translate sid=\"place\">0 0 0.5</translate>"},
                  {kTorsoChannel, "<channel source=\"#mTorso-sampler\" target=\"mTorso/place\"/>"}},
                 "WC1039", "target=\"mTorso/place\"", "animation[id=mTorso-move]/channel");
}

TEST(GazeboMotionRulesTest, withoutASkinNothingMoves) {
    expectGazebo({kNoInstance,
                  {"          <skeleton>#mPelvis</skeleton>\n", ""},
                  {"</instance_controller>", "</instance_geometry>"}},
                 "WC1040", "<library_animations>", "COLLADA/library_animations");
}

TEST(GazeboMotionRulesTest, aNestedAnimationIsNotReadWhereTheFirstIsNot) {
    expectGazebo({{"    <animation id=\"mTorso-move\">",
                   "    <animation id=\"outer\">\n<animation id=\"mTorso-move\">"},
                  {kTorsoChannel + "\n    </animation>", kTorsoChannel + "\n    </animation></animation>"}},
                 "WC1041", kTorsoChannel, "animation[id=mTorso-move]/channel");
}

TEST(GazeboMotionRulesTest, otherKeyTimesPutAJointToRest) {
    expectGazebo({{"<float_array id=\"mTorso-times-array\" count=\"2\">0 1<",
                   "<float_array id=\"mTorso-times-array\" count=\"2\">0 2<"},
                  {"target=\"mTorso/transform\"", "target=\"mPelvis/transform\""}},
                 "WC1042", "<channel source=\"#mTorso-sampler\"", "animation[id=mTorso-move]/channel");
}

TEST(GazeboMotionRulesTest, clipsAreNotKnown) {
    expectGazebo(
        {{"  <library_visual_scenes>",
          "<library_animation_clips>\n<animation_clip id=\"walk\" start=\"0\" end=\"1\"><instance_animation "
          "url=\"#mTorso-move\"/></animation_clip></library_animation_clips>\n  <library_visual_scenes>"}},
        "WC1043", "<animation_clip ", "animation_clip[id=walk]");
}

TEST(GazeboMotionRulesTest, anEmptyLibraryOfAnimationsCrashesIt) {
    const std::string text = cleanDocument();
    const std::size_t begin = text.find("<library_animations>"), end = text.find("</library_animations>");
    expectSaid(Profile::Gazebo, text.substr(0, begin) + "<library_animations>" + text.substr(end), "WC1049",
               "<library_animations>", "COLLADA/library_animations");
}

}  // namespace
}  // namespace walkcycle
