// Skins and morphs whose references, widths and counts are wrong: what is said, where, and what is still shown.
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/controllers/SkinLoader.h"

namespace walkcycle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return text.replace(at, from.size(), to);
}

SkinText plainSkin() {
    SkinText skin;
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    return skin;
}

const std::string kRig =
    "<node id='hip' sid='hip'><translate>1 0 0</translate><node id='knee' sid='knee'/></node>\n";
const std::string kBody = "<node id='body' name='Body'><instance_controller url='#skin'/></node>\n";

std::string document(const SkinText& skin, const std::string& nodes = kRig + kBody) {
    return collada(triangle() + controllers(skin.text()) + scene(nodes));
}

std::string listOf(const std::string& word, int count) {
    std::string words;
    for (int i = 0; i < count; ++i) words += word + std::to_string(i) + "\n";
    return words;
}

TEST(SkinFaultsTest, inverseBindMatricesThatAreNotThereAreThoseOfTheRestPose) {
    const std::string text = document(plainSkin());
    for (const std::string& damaged :
         {replaced(text, "\"INV_BIND_MATRIX\" source=\"#binds\"", "\"INV_BIND_MATRIX\" source=\"#none\""),
          replaced(text, "float_array id=\"binds-array\"", "odd_array id=\"binds-array\""),
          replaced(text, "stride=\"16\"><param name=\"TRANSFORM\" type=\"float4x4\"/>", "stride=\"4\">")}) {
        const Model model =
            loadText(damaged.find("odd_array") == damaged.npos
                         ? damaged
                         : replaced(damaged, "</float_array>\n<technique_common><accessor source=\"#binds",
                                    "</odd_array>\n<technique_common><accessor source=\"#binds"));
        EXPECT_THAT(codes(model.diagnostics), Contains("WC0405"));
        EXPECT_THAT(posed(model), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0)));
    }
}

TEST(SkinFaultsTest, aSourceOfMatricesThatIsNotSixteenWideIsReportedThere) {
    const std::string text =
        replaced(document(plainSkin()), "stride=\"16\"><param name=\"TRANSFORM\" type=\"float4x4\"/>",
                 "stride=\"4\">");
    const Model model = loadText(text);
    ASSERT_THAT(codes(model.diagnostics), Contains("WC0205"));
    EXPECT_THAT(model.diagnostics[0].message, HasSubstr("INV_BIND_MATRIX"));
    EXPECT_EQ(model.diagnostics[0].line, lineOf(text, "<source id=\"binds\""));
}

TEST(SkinFaultsTest, severalSingularMatricesAreSaidOnceAtTheFirst) {
    SkinText skin = plainSkin();
    skin.inverseBinds =
        matrixSource("binds", "0 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n0 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
    const std::string text = document(skin);
    const Model model = loadText(text);
    ASSERT_THAT(codes(model.diagnostics), ElementsAre("WC0411"));
    EXPECT_EQ(model.diagnostics[0].line, lineOf(text, "0 0 0 0 0 1"));
}

TEST(SkinFaultsTest, aRestPoseThatIsFlatBindsWithoutMovingAnything) {
    const std::string flat =
        "<node id='hip' sid='hip'><scale>0 0 0</scale><node id='knee' sid='knee'/></node>\n";
    const Model model = loadText(document(SkinText{}, flat + kBody));
    for (const glm::vec3& position : posed(model)) EXPECT_EQ(position, glm::vec3(0.0f));
    EXPECT_EQ(model.skins.at(0).bindMatrices[0], glm::mat4(1.0f));
}

TEST(SkinFaultsTest, jointNamesThatAreNotThereLeaveTheMeshUnskinned) {
    const std::string text = document(plainSkin());
    for (const std::string& damaged :
         {replaced(text, "<input semantic=\"JOINT\" source=\"#joints\"/>",
                   "<input semantic=\"JOINT\" source=\"#none\"/>"),
          replaced(text, "<input semantic=\"JOINT\" source=\"#joints\"/>",
                   "<input semantic=\"JOINT\" source=\"#weights\"/>"),
          replaced(text, "<input semantic=\"JOINT\" source=\"#joints\"/>", "")}) {
        const Model model = loadText(damaged);
        EXPECT_THAT(model.instances.at(0).deformers, IsEmpty());
        EXPECT_THAT(posed(model)[1], isAt(1, 0, 0));
    }
    const std::string none = replaced(text, "<input semantic=\"JOINT\" source=\"#joints\"/>", "");
    const Model model = loadText(none);
    ASSERT_THAT(codes(model.diagnostics), Contains("WC0203"));
    EXPECT_EQ(model.diagnostics[0].line, lineOf(none, "<joints>"));
}

TEST(SkinFaultsTest, jointNamesInPairsAreReported) {
    SkinText skin = plainSkin();
    skin.joints = replaced(
        skin.joints, "count=\"2\" stride=\"1\"><param name=\"JOINT\" type=\"name\"/>",
        "count=\"1\" stride=\"2\"><param name=\"A\" type=\"name\"/><param name=\"B\" type=\"name\"/>");
    EXPECT_THAT(codes(loadText(document(skin)).diagnostics), Contains("WC0306"));
}

TEST(SkinFaultsTest, theListOfJointsMayBeNamedInTwoWaysOrNotAtAll) {
    const std::string text = document(plainSkin());
    const auto weightsNaming = [&](const std::string& source) {
        std::string changed = text;
        const std::size_t at = changed.find("#joints", changed.find("<vertex_weights"));
        return changed.replace(at, 7, source);
    };
    EXPECT_THAT(codes(loadText(weightsNaming("test.dae#joints")).diagnostics), Not(Contains("WC0417")));
    EXPECT_THAT(codes(loadText(weightsNaming("#none")).diagnostics), ElementsAre("WC0201"));
    EXPECT_THAT(codes(loadText(weightsNaming("")).diagnostics), Not(Contains("WC0417")));
    const Model model =
        loadText(replaced(text, "<input semantic=\"JOINT\" source=\"#joints\" offset=\"0\"/>", ""));
    EXPECT_THAT(codes(model.diagnostics), Not(Contains("WC0417")));
}

TEST(SkinFaultsTest, ofManyMissingJointsTheFirstAreLookedForInTheText) {
    SkinText skin;
    skin.joints = nameSource("joints", listOf("gone", 5));
    const std::string text = document(skin);
    std::vector<int> lines;
    int more = 0;
    for (const Diagnostic& said : loadText(text).diagnostics)
        if (said.code == "WC0401") {
            lines.push_back(said.line - lineOf(text, "gone0"));
            more += said.repeats;
        }
    EXPECT_THAT(lines, ElementsAre(0, 1, 2));
    EXPECT_EQ(more, 2);
}

TEST(SkinFaultsTest, aSkinOnItsOwnJointIsNotPlacedTwice) {
    LoadOptions apply;
    apply.skinNode = SkinNode::Apply;
    const std::string on =
        "<node id='hip' sid='hip'><translate>1 0 0</translate><node id='knee' sid='knee'/>"
        "<instance_controller url='#skin'/></node>\n";
    const Model model = loadText(document(plainSkin(), on), apply);
    EXPECT_THAT(posed(model)[0], isAt(1, 0, 0));
    EXPECT_THAT(model.diagnostics, IsEmpty());
}

// ---- weights

TEST(SkinFaultsTest, weightsThatAreNotThereLeaveTheMeshWithItsNode) {
    const std::string text = document(plainSkin());
    for (const std::string& damaged : {replaced(text, "<input semantic=\"WEIGHT\" source=\"#weights\"",
                                                "<input semantic=\"WEIGHT\" source=\"#none\""),
                                       replaced(text, "<input semantic=\"WEIGHT\" source=\"#weights\"",
                                                "<input semantic=\"WEIGHT\" source=\"#joints\"")}) {
        const Model model = loadText(damaged);
        EXPECT_THAT(codes(model.diagnostics), Contains("WC0203"));
        EXPECT_THAT(posed(model)[1], isAt(1, 0, 0));
    }
}

TEST(SkinFaultsTest, ofWeightsInPairsTheFirstCounts) {
    SkinText skin = plainSkin();
    skin.weights = floatSource("weights", "1 9 1 9 1 9", "WX");
    const Model model = loadText(document(skin));
    EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0306"));
    EXPECT_THAT(posed(model)[0], isAt(1, 0, 0));
}

TEST(SkinFaultsTest, weightsTooSmallOrTooLargeForASumAreNone) {
    SkinText skin = plainSkin();
    skin.weights = floatSource("weights", "1e-30 3e38", "W");
    skin.vcount = "1 2 1";
    skin.v = "0 0  0 1 1 1  1 1";
    const Model model = loadText(document(skin));
    EXPECT_THAT(codes(model.diagnostics), Contains("WC0403"));
    const std::vector<glm::vec3> at = posed(model);
    EXPECT_THAT(at, ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(1, 1, 0)));
}

TEST(SkinFaultsTest, badInfluencesAreErrorsInTheirLinesAsFarAsThoseAreLookedFor) {
    SkinText skin = plainSkin();
    skin.weights = floatSource("weights", "1 -1 -2", "W");
    skin.vcount = "4 5 1";
    skin.v = "0 0\n0 -1\n0 7\n0 8\n0 0 0 9\n0 1 0 2 0 0 0 0";
    const std::string text = document(skin);
    std::vector<int> lines;
    std::size_t negative = 0;
    int more = 0;
    for (const Diagnostic& said : loadText(text).diagnostics) {
        if (said.code == "WC0409") lines.push_back(said.line - lineOf(text, "<v>")), more += said.repeats;
        if (said.code == "WC0408") negative += said.message.find("2 weights") != std::string::npos;
    }
    EXPECT_THAT(lines, ElementsAre(1, 2, 3));
    EXPECT_EQ(more, 1);
    EXPECT_EQ(negative, 1u);
}

TEST(SkinFaultsTest, countsOfWeightsThatAreNoNumbersOrMissingAreReported) {
    const std::string text = document(plainSkin());
    const Model odd =
        loadText(replaced(text, "<vertex_weights count=\"3\">", "<vertex_weights count=\"x\">"));
    EXPECT_THAT(codes(odd.diagnostics), ElementsAre("WC0202"));
    EXPECT_THAT(posed(odd)[0], isAt(1, 0, 0));
    const std::string none = replaced(text, "<vcount>1 1 1</vcount>", "");
    bool isSaid = false;
    for (const Diagnostic& said : loadText(none).diagnostics)
        isSaid = isSaid || (said.code == "WC0205" && said.line == lineOf(none, "<vertex_weights") &&
                            said.message.find("3 in <v>") != std::string::npos);
    EXPECT_TRUE(isSaid);
}

// ---- morphs

const std::string kTargets =
    "<targets><input semantic='MORPH_TARGET' source='#names'/>"
    "<input semantic='MORPH_WEIGHT' source='#amounts'/></targets>";

Model morphWith(const std::string& targets, const std::string& names = "high") {
    return loadText(
        collada(triangle() + triangle("high", "0 0 2 1 0 2 0 1 2") +
                controllers("<controller id='morph'><morph source='#mesh'>\n" +
                            nameSource("names", names, "IDREF_array") + floatSource("amounts", "1", "W") +
                            targets + "</morph></controller>") +
                scene("<node><instance_controller url='#morph'/></node>")));
}

TEST(SkinFaultsTest, aMorphWithoutTargetsShowsItsBase) {
    EXPECT_THAT(posed(morphWith(kTargets))[0], isAt(0, 0, 2));
    for (const std::string& targets :
         {std::string(), replaced(kTargets, "#names", "#none"), replaced(kTargets, "#amounts", "#none"),
          replaced(kTargets, "#names", "#mesh"), replaced(kTargets, "#amounts", "#names")}) {
        const Model model = morphWith(targets);
        EXPECT_THAT(codes(model.diagnostics), Contains(testing::StartsWith("WC0"))) << targets;
        EXPECT_THAT(posed(model)[0], isAt(0, 0, 0)) << targets;
    }
    EXPECT_THAT(codes(morphWith("").diagnostics), ElementsAre("WC0203"));
}

TEST(SkinFaultsTest, ofManyMissingTargetsTheFirstAreLookedForInTheText) {
    const Model model = morphWith(kTargets, listOf("gone", 5));
    std::vector<int> lines;
    for (const Diagnostic& said : model.diagnostics)
        if (said.code == "WC0201") lines.push_back(said.line);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[2] - lines[0], 2);
}

}  // namespace
}  // namespace walkcycle
