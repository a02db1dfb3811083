#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/controllers/WeightsReader.h"

namespace walkcycle {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::uint32_t kNode = 2;  // the entry behind the two joints: the skin's own node

// The influences of each position of a skin of two joints, "joint:weight joint:weight", and what was said.
struct Weights {
    explicit Weights(const SkinText& skin, LoadOptions options = {}, std::size_t positions = 3)
        : text("<COLLADA>" + skin.text() + "</COLLADA>"), load(text, std::move(options)) {
        const XmlNode element = load.byId("skin").child("skin").child("vertex_weights");
        result = readWeights(element, positions, kNode, load.context);
    }
    std::string of(std::size_t position) const {
        std::string words;
        for (std::uint32_t i = result.first[position]; i < result.first[position + 1]; ++i)
            words += (words.empty() ? "" : " ") + std::to_string(result.influences[i].joint) + ":" +
                     std::to_string(static_cast<int>(std::lround(100 * result.influences[i].weight)));
        return words;
    }
    std::vector<std::string> all() const {
        std::vector<std::string> each;
        for (std::size_t p = 0; p + 1 < result.first.size(); ++p) each.push_back(of(p));
        return each;
    }
    const std::vector<Diagnostic>& said() const { return load.diagnostics.all(); }
    int line(const char* part) const { return lineOf(text, part); }

    std::string text;
    TestLoad load;
    Influences result;
};

const std::string kPath = "COLLADA/controller[id=skin]/skin/vertex_weights";

SkinText skinOf(const std::string& vcount, const std::string& v, const std::string& weights = "1 0.5 0.25") {
    SkinText skin;
    skin.vcount = vcount;
    skin.v = v;
    skin.weights = floatSource("weights", weights, "W");
    return skin;
}

TEST(WeightsReaderTest, eachPositionHasItsOwnNumberOfInfluences) {
    const Weights weights(skinOf("1 2\n\t2", "0 0  0 1 1 1\n<!-- the last -->1 1 0 1"));
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "0:50 1:50", "1:50 0:50"));
    EXPECT_THAT(weights.said(), IsEmpty());
}

TEST(WeightsReaderTest, nineInfluencesAreNineInfluences) {
    const Weights weights(skinOf("9 1 1", "0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 0 1 1 1", "0.1111111 1"));
    EXPECT_EQ(weights.result.first[1], 9u);
    EXPECT_THAT(weights.said(), IsEmpty());
}

TEST(WeightsReaderTest, weightsThatDoNotSumToOneAreNormalisedAndSaidOnce) {
    const Weights weights(skinOf("2 1 1", "0 0 1 1  0 1  1 0", "3 1"));
    EXPECT_THAT(weights.all(), ElementsAre("0:75 1:25", "0:100", "1:100"));
    EXPECT_THAT(weights.said(), ElementsAre(says("WC0402", weights.line("<v>"), kPath + "/v")));
    EXPECT_THAT(weights.said()[0].message, testing::HasSubstr("2 vertices"));
    EXPECT_THAT(weights.said()[0].message, testing::HasSubstr("worst: 4"));
}

TEST(WeightsReaderTest, whatExportersRoundOffIsNormalisedInSilence) {
    const Weights weights(skinOf("2 1 1", "0 0 1 0  0 1  1 1", "0.495 0.999"));
    EXPECT_THAT(weights.all(), ElementsAre("0:50 1:50", "0:100", "1:100"));
    EXPECT_THAT(weights.said(), IsEmpty());
}

TEST(WeightsReaderTest, jointMinusOneIsTheSkinsNode) {
    const Weights weights(skinOf("2 1 1", "-1 1 1 1  -1 0  0 0"));
    EXPECT_THAT(weights.all(), ElementsAre("2:50 1:50", "2:100", "0:100"));
    EXPECT_THAT(weights.said(), IsEmpty());
}

TEST(WeightsReaderTest, aVertexWithoutWeightStaysWithTheSkinsNode) {
    const Weights weights(skinOf("0 1 1", "0 1  1 0", "1 0"));
    EXPECT_THAT(weights.all(), ElementsAre("2:100", "2:100", "1:100"));
    EXPECT_THAT(weights.said(), ElementsAre(says("WC0403", weights.line("<vcount"), kPath + "/vcount")));
    EXPECT_THAT(weights.said()[0].message, testing::HasSubstr("2 vertices"));
}

TEST(WeightsReaderTest, negativeWeightsCountAsZero) {
    const Weights weights(skinOf("2 1 1", "0 0 1 1  0 0  1 0", "1 -1"));
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "0:100", "1:100"));
    EXPECT_THAT(weights.said(),
                ElementsAre(says(
                    "WC0408", weights.line("<float_array id=\"weights-array"),
                    "COLLADA/controller[id=skin]/skin/source[id=weights]/float_array[id=weights-array]")));
}

TEST(WeightsReaderTest, aWeightThatIsNoNumberIsAnErrorAndNeverPassedOn) {
    const Weights weights(skinOf("2 1 1", "0 0 1 1  0 1  1 0", "1 NaN"));
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "2:100", "1:100"));
    EXPECT_THAT(codes(weights.said()), ElementsAre("WC0204", "WC0403"));
}

TEST(WeightsReaderTest, indicesOutsideTheirSourceAreErrorsInTheLineOfV) {
    const Weights weights(skinOf("2 2 1", "0 0 2 0  1 0 0 3  -2 0"));
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "1:100", "2:100"));
    const int line = weights.line("<v>");
    const auto outside = says("WC0409", line, kPath + "/v");
    EXPECT_THAT(weights.said(), ElementsAre(outside, outside, outside,
                                            says("WC0403", weights.line("<vcount"), kPath + "/vcount")));
}

// Four influences, of which the third position wants three: two are left.
TEST(WeightsReaderTest, aCountIsHeldAgainstWhatThePositionsBeforeItLeft) {
    const Weights weights(skinOf("1 1 3", "0 0  1 0  0 0  1 0"));
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "1:100", "2:100"));
    ASSERT_THAT(codes(weights.said()), ElementsAre("WC0205", "WC0410"));
    EXPECT_EQ(weights.said()[0].elementPath, kPath + "/vcount");
    EXPECT_THAT(weights.said()[0].message, testing::HasSubstr("at least 5"));
}

TEST(WeightsReaderTest, aSecondWeightInputIsNotUsed) {
    SkinText skin = skinOf("1 1 1", "0 0 9  0 0 9  1 0 9");
    skin.weightInputs = "<input semantic=\"WEIGHT\" source=\"#weights\" offset=\"2\"/>\n";
    const Weights weights(skin);
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "0:100", "1:100"));
    EXPECT_THAT(weights.said(), ElementsAre(says("WC0412", weights.line("offset=\"2\""), kPath + "/input")));
}

TEST(WeightsReaderTest, inputsMayShareAnOffset) {
    SkinText skin = skinOf("1 1 1", "0 1 0", "1 1");
    std::string text = "<COLLADA>" + skin.text() + "</COLLADA>";
    text.replace(text.find("offset=\"1\""), 10, "offset=\"0\"");
    TestLoad load(text);
    const Influences result =
        readWeights(load.byId("skin").child("skin").child("vertex_weights"), 3, kNode, load.context);
    EXPECT_EQ(result.influences[1].joint, 1u);
    EXPECT_THAT(load.diagnostics.all(), IsEmpty());
}

TEST(WeightsReaderTest, aVcountThatAsksForMoreThanVHoldsIsCutThere) {
    const Weights weights(skinOf("1 5 1", "0 0  1 0  1 0"));
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "2:100", "2:100"));
    EXPECT_THAT(weights.said(), Contains(says("WC0205", weights.line("<vcount"), kPath + "/vcount")));
    EXPECT_THAT(codes(weights.said()), Contains("WC0410"));
}

TEST(WeightsReaderTest, countsThatAreNegativeOrHugeAllocateNothing) {
    for (const char* vcount : {"-1 1 1", "1 -2147483648 1"}) {
        const Weights weights(skinOf(vcount, "0 0  1 0  1 0"));
        EXPECT_EQ(weights.result.first.size(), 4u) << vcount;
        EXPECT_THAT(codes(weights.said()), Contains("WC0205")) << vcount;
    }
}

TEST(WeightsReaderTest, moreInVThanVcountTellsIsReported) {
    const Weights weights(skinOf("1 1 1", "0 0  1 0  1 0  1 0"));
    EXPECT_THAT(weights.all(), ElementsAre("0:100", "1:100", "1:100"));
    EXPECT_THAT(weights.said(), ElementsAre(says("WC0205", weights.line("<vcount"), kPath + "/vcount")));
}

TEST(WeightsReaderTest, theCountMustAgreeWithVcount) {
    SkinText skin;
    skin.positions = 4;
    EXPECT_THAT(Weights(skin).said(),
                Contains(says("WC0205", lineOf("<COLLADA>" + skin.text(), "<vertex_weights"), kPath)));
}

TEST(WeightsReaderTest, positionsBeyondTheWeightsStayWithTheNodeAndWeightsBeyondThePositionsAreLeftOut) {
    const Weights shorter(SkinText{}, {}, 5);
    EXPECT_THAT(shorter.all(), ElementsAre("0:100", "1:100", "1:100", "2:100", "2:100"));
    EXPECT_THAT(codes(shorter.said()), ElementsAre("WC0410"));
    const Weights longer(SkinText{}, {}, 2);
    EXPECT_THAT(longer.all(), ElementsAre("0:100", "1:100"));
}

TEST(WeightsReaderTest, withoutAnInputAllStaysWithTheNode) {
    for (const char* semantic : {"WEIGHT", "JOINT"}) {
        std::string text = "<COLLADA>" + SkinText{}.text() + "</COLLADA>";
        const std::size_t at =
            text.find("semantic=\"" + std::string(semantic) + "\"", text.find("<vertex_weights"));
        text.replace(at, 10, "semantic=\"_");
        TestLoad load(text);
        const Influences result =
            readWeights(load.byId("skin").child("skin").child("vertex_weights"), 3, kNode, load.context);
        EXPECT_EQ(result.influences.size(), 3u);
        EXPECT_THAT(load.diagnostics.all(), Contains(says("WC0203", lineOf(text, "<vertex_weights"), kPath)));
    }
}

TEST(WeightsReaderTest, theLimitOfInfluencesHoldsAtItsInfluence) {
    const SkinText skin = skinOf("3 1 1", "0 2 0 2 1 1  0 0  1 0");
    for (const std::uint64_t limit : {4u, 3u}) {
        LoadOptions options;
        options.limits.maxInfluencesPerVertex = limit;
        EXPECT_THAT(Weights(skin, options).of(0), "0:25 0:25 1:50");
    }
    LoadOptions options;
    options.limits.maxInfluencesPerVertex = 2;
    EXPECT_THROW(Weights(skin, options), LoadError);
}

}  // namespace
}  // namespace walkcycle
