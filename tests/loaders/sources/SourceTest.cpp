#include <memory>
#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/sources/Inputs.h"
#include "loaders/sources/Source.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kPath = "COLLADA/source[id=s]";

// A source of numbers with this accessor; the array is "a".
std::string source(const std::string& numbers, const std::string& accessor,
                   const std::string& arrayAttributes) {
    return "<COLLADA>\n<source id='s'>\n<float_array id='a' " + arrayAttributes + ">" + numbers +
           "</float_array>\n<technique_common>\n" + accessor + "\n</technique_common></source></COLLADA>";
}

std::string source(const std::string& numbers, const std::string& accessor) {
    return source(numbers, accessor, "count='" + std::to_string(splitWords(numbers).size()) + "'");
}

// Reading one source: what came out, and what was said.
struct Reading {
    explicit Reading(const std::string& text, NumberFaults faultsAre = NumberFaults::Error) : load(text) {
        result = load.sources.floats(load.byId("s"), faultsAre);
        if (result) values = result->values;
    }
    const std::vector<Diagnostic>& said() const { return load.diagnostics.all(); }

    TestLoad load;
    std::shared_ptr<const FloatSource> result;
    std::vector<float> values;
};

TEST(SourceTest, anAccessorGivesEntriesOfItsStride) {
    const Reading reading(source("1 2 3 4 5 6",
                                 "<accessor source='#a' count='2' stride='3'>"
                                 "<param name='X' type='float'/><param name='Y' type='float'/>"
                                 "<param name='Z' type='float'/></accessor>"));
    EXPECT_EQ(reading.result->count(), 2u);
    EXPECT_EQ(reading.result->width, 3u);
    EXPECT_THAT(reading.result->params, ElementsAre("X", "Y", "Z"));
    EXPECT_EQ((*reading.result)[1][0], 4.0f);
    EXPECT_THAT(reading.said(), IsEmpty());
}

TEST(SourceTest, offsetAndStrideLeaveOutWhatLiesBetween) {
    const Reading reading(source("9 1 2 9 9 3 4 9",
                                 "<accessor source='#a' count='2' offset='1' stride='4'>"
                                 "<param name='S' type='float'/><param name='T' type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(reading.said(), IsEmpty());
}

TEST(SourceTest, aParamWithoutANameIsSkipped) {
    const Reading reading(source("1 9 2 3 9 4",
                                 "<accessor source='#a' count='2' stride='3'>"
                                 "<param name='X' type='float'/><param type='float'/>"
                                 "<param name='Z' type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(reading.said(), IsEmpty());
}

TEST(SourceTest, whereNoParamHasANameEveryValueCounts) {
    const Reading reading(source("1 2 3 4",
                                 "<accessor source='#a' count='2' stride='2'>"
                                 "<param type='float'/><param type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2, 3, 4));
}

TEST(SourceTest, oneParamStandsForAWholeMatrix) {
    for (const char* type : {"float4x4", "float"}) {
        const Reading reading(
            source(kIdentity, "<accessor source='#a' count='1' stride='16'><param name='TRANSFORM' type='" +
                                  std::string(type) + "'/></accessor>"));
        EXPECT_EQ(reading.result->width, 16u) << type;
        EXPECT_THAT(reading.said(), IsEmpty());
    }
}

TEST(SourceTest, aCountBeyondTheArrayIsAnErrorAndWhatIsThereIsGiven) {
    const Reading reading(source("1 2 3 4 5",
                                 "<accessor source='#a' count='1000000000000' stride='2'>"
                                 "<param name='S' type='float'/><param name='T' type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(reading.said(), ElementsAre(says("WC0211", 5, kPath + "/technique_common/accessor")));
}

TEST(SourceTest, numbersThatWrapRoundIn64BitsAreNotBelieved) {
    for (const char* accessor :
         {"count='18446744073709551615' stride='2'", "count='2' stride='18446744073709551615'",
          "count='2' stride='2' offset='18446744073709551615'",
          "count='9223372036854775808' stride='9223372036854775808' offset='1'"}) {
        const Reading reading(source(
            "1 2 3 4", "<accessor source='#a' " + std::string(accessor) +
                           "><param name='S' type='float'/><param name='T' type='float'/></accessor>"));
        EXPECT_LE(reading.values.size(), 4u) << accessor;
        EXPECT_THAT(codes(reading.said()), Contains("WC0211")) << accessor;
    }
}

TEST(SourceTest, aMissingStrideWithThreeParamsIsThree) {
    const Reading reading(source("1 2 3 4 5 6",
                                 "<accessor source='#a' count='2'>"
                                 "<param name='X' type='float'/><param name='Y' type='float'/>"
                                 "<param name='Z' type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(reading.said(), ElementsAre(says("WC0205", 5, kPath + "/technique_common/accessor")));
}

TEST(SourceTest, aStrideOfZeroIsAFault) {
    const Reading reading(source(
        "1 2", "<accessor source='#a' count='2' stride='0'><param name='X' type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2));
    EXPECT_THAT(reading.said(), ElementsAre(says("WC0204", 5, kPath + "/technique_common/accessor")));
}

TEST(SourceTest, anAccessorThatNamesItsSourceMeansItsArray) {
    const Reading reading(
        source("1 2", "<accessor source='#s' count='2'><param name='X' type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2));
    EXPECT_THAT(reading.said(), IsEmpty());
}

TEST(SourceTest, anAccessorThatLeadsNowhereIsAnErrorAndTheOwnArrayIsRead) {
    const Reading reading(
        source("1 2", "<accessor source='#gone' count='2'><param name='X' type='float'/></accessor>"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2));
    EXPECT_THAT(reading.said(), ElementsAre(says("WC0201", 5, kPath + "/technique_common/accessor")));
}

TEST(SourceTest, anArrayInAnotherSourceIsReadWhereTheAccessorSaysSo) {
    const Reading reading(
        "<COLLADA><source id='other'><float_array id='b' count='2'>7 8</float_array></source>"
        "<source id='s'><technique_common><accessor source='#b' count='2'><param name='X' "
        "type='float'/></accessor>"
        "</technique_common></source></COLLADA>");
    EXPECT_THAT(reading.values, ElementsAre(7, 8));
    EXPECT_THAT(reading.said(), IsEmpty());
}

TEST(SourceTest, withoutAnAccessorTheArrayItselfIsGivenAndTheFaultReported) {
    const Reading reading(
        "<COLLADA>\n<source id='s'><float_array id='a' count='2'>1 2</float_array></source></COLLADA>");
    EXPECT_THAT(reading.values, ElementsAre(1, 2));
    EXPECT_THAT(reading.said(), ElementsAre(says("WC0203", 2, kPath)));
}

TEST(SourceTest, aSourceWithoutAnArrayIsNothing) {
    const Reading reading("<COLLADA>\n<source id='s'/></COLLADA>");
    EXPECT_FALSE(reading.result);
    EXPECT_THAT(codes(reading.said()), Contains("WC0203"));
}

TEST(SourceTest, theCountOfAnArrayMustBeThereAndTrue) {
    const std::string accessor = "<accessor source='#a' count='2'><param name='X' type='float'/></accessor>";
    const auto said = [&](const char* count) {
        return codes(Reading(source("1 2", accessor, count)).said());
    };
    EXPECT_THAT(said("count='2'"), IsEmpty());
    EXPECT_THAT(said("count='+2'"), IsEmpty());
    EXPECT_THAT(said(""), ElementsAre("WC0202"));
    EXPECT_THAT(said("count='3'"), ElementsAre("WC0205"));
    EXPECT_THAT(said("count='18446744073709551615'"), ElementsAre("WC0205"));
    for (const char* odd :
         {"count='0x2'", "count='2.0'", "count='-2'", "count=''", "count='18446744073709551616'"})
        EXPECT_THAT(said(odd), ElementsAre("WC0204")) << odd;
}

TEST(SourceTest, aNumberThatCannotBeUsedBecomesZeroAndIsReportedInItsLine) {
    const std::string text =
        source("1 2\n\n3 NaN\nINF 1e400",
               "<accessor source='#a' count='6'><param name='X' type='float'/></accessor>");
    const Reading asError(text);
    EXPECT_THAT(asError.values, ElementsAre(1, 2, 3, 0, 0, 0));
    EXPECT_THAT(asError.said(), ElementsAre(says("WC0204", 5, kPath + "/float_array[id=a]"),
                                            says("WC0204", 6, kPath + "/float_array[id=a]"),
                                            says("WC0204", 6, kPath + "/float_array[id=a]")));
    const Reading asWarning(text, NumberFaults::Warning);
    EXPECT_THAT(codes(asWarning.said()), ElementsAre("WC0210", "WC0210", "WC0210"));
}

TEST(SourceTest, theLineOfABadNumberIsRightWhereTheListBeginsOnALineOfItsOwn) {
    const Reading reading(
        source("\n\n1 2\nx\n", "<accessor source='#a' count='3'><param name='X' type='float'/></accessor>"));
    EXPECT_THAT(reading.said(), ElementsAre(says("WC0204", 6, kPath + "/float_array[id=a]")));
}

TEST(SourceTest, theLineOfABadNumberIsRightAfterAComment) {
    const Reading reading(source("1\n<!-- \n\n -->\n2\nx",
                                 "<accessor source='#a' count='3'><param name='X' type='float'/></accessor>",
                                 "count='3'"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2, 0));
    EXPECT_THAT(reading.said(), ElementsAre(says("WC0204", 8, kPath + "/float_array[id=a]")));
}

TEST(SourceTest, namesAndIdrefsAreToldApart) {
    TestLoad load("<COLLADA>" + nameSource("n", "hip\n knee.L") + nameSource("i", "hip knee", "IDREF_array") +
                  "</COLLADA>");
    bool isIdref = true;
    EXPECT_THAT(load.sources.names(load.byId("n"), isIdref)->values, ElementsAre("hip", "knee.L"));
    EXPECT_FALSE(isIdref);
    EXPECT_THAT(load.sources.names(load.byId("i"), isIdref)->values, ElementsAre("hip", "knee"));
    EXPECT_TRUE(isIdref);
    EXPECT_THAT(load.diagnostics.all(), IsEmpty());
}

TEST(SourceTest, aSourceIsReadOnceHoweverOftenItIsAskedFor) {
    TestLoad load("<COLLADA>" + floatSource("s", "1 2 x") + "</COLLADA>");
    const auto first = load.sources.floats(load.byId("s"), NumberFaults::Error);
    EXPECT_EQ(load.sources.floats(load.byId("s"), NumberFaults::Error), first);
    EXPECT_THAT(codes(load.diagnostics.all()), ElementsAre("WC0204"));
}

TEST(SourceTest, inputsKeepSemanticOffsetAndSet) {
    TestLoad load(
        "<COLLADA><p><input semantic='TEXCOORD' source='#s' offset='2' set='1'/>"
        "<input semantic='VERTEX' source='#s'/></p>" +
        floatSource("s", "1 2 3") + "</COLLADA>");
    const std::vector<Input> inputs = readInputs(load.collada.child("p"), load.documents, load.diagnostics);
    ASSERT_EQ(inputs.size(), 2u);
    EXPECT_EQ(inputs[0].semantic, "TEXCOORD");
    EXPECT_EQ(inputs[0].offset, 2);
    EXPECT_EQ(inputs[0].set, 1);
    EXPECT_EQ(inputs[0].source, load.byId("s"));
    EXPECT_FALSE(inputs[1].hasSet);
    EXPECT_THAT(load.diagnostics.all(), IsEmpty());
}

TEST(SourceTest, anInputThatLeadsNowhereOrHasNoUsableOffsetIsReported) {
    TestLoad load(
        "<COLLADA><p>\n<input semantic='POSITION' source='#gone'/>\n<input semantic='NORMAL'/>\n"
        "<input semantic='COLOR' source='#s' offset='-1'/></p>" +
        floatSource("s", "1 2 3") + "</COLLADA>");
    const std::vector<Input> inputs = readInputs(load.collada.child("p"), load.documents, load.diagnostics);
    EXPECT_FALSE(inputs[0].source);
    EXPECT_FALSE(inputs[1].source);
    EXPECT_EQ(inputs[2].offset, 0);
    EXPECT_THAT(load.diagnostics.all(),
                ElementsAre(says("WC0201", 2, "COLLADA/p/input"), says("WC0202", 3, "COLLADA/p/input"),
                            says("WC0204", 4, "COLLADA/p/input")));
}

TEST(SourceTest, listsOfIndicesSpeakOfTheirOwnElement) {
    TestLoad load("<COLLADA>\n<p>0 1\n2.5</p></COLLADA>");
    EXPECT_THAT(readInts(load.collada.child("p"), load.diagnostics), ElementsAre(0, 1, 0));
    EXPECT_THAT(load.diagnostics.all(), ElementsAre(says("WC0204", 3, "COLLADA/p")));
}

TEST(SourceTest, aTypeOfSeveralNumbersTakesAsMany) {
    for (const char* type : {"float3", "double3", "float3z"}) {
        const Reading reading(
            source("1 2 3 4 5 6", "<accessor source='#a' count='2' stride='3'><param name='P' type='" +
                                      std::string(type) + "'/></accessor>"));
        EXPECT_EQ(reading.result->width, 3u) << type;
        EXPECT_THAT(reading.said(), IsEmpty()) << type;
    }
    const Reading square(source("1 2 3 4",
                                "<accessor source='#a' count='1' stride='4'><param name='P' "
                                "type='float2x2'/></accessor>"));
    EXPECT_EQ(square.result->width, 4u);
}

TEST(SourceTest, moreParamsThanAnythingHasDoNotWidenTheEntries) {
    std::string params;
    for (int i = 0; i < 17; ++i) params += "<param name='P' type='float'/>";
    const Reading reading(source("1 2 3", "<accessor source='#a' count='3'>" + params + "</accessor>"));
    EXPECT_THAT(codes(reading.said()), Contains("WC0205"));
    EXPECT_THAT(reading.values, ElementsAre(1, 2, 3));
}

TEST(SourceTest, anAccessorWithoutACountGivesWhatThereIsAndIsReported) {
    const Reading reading(source("1 2 3 4", "<accessor source='#a' stride='2'/>"));
    ASSERT_THAT(codes(reading.said()), ElementsAre("WC0202"));
    EXPECT_EQ(reading.result->count(), 2u);
    const Reading none(source("1 2 3 4", "<accessor source='#a' count='0'/>"));
    EXPECT_EQ(none.result->count(), 0u);
    const Reading uneven(source("1 2 3 4 5", "<accessor source='#a' count='2'/>"));
    EXPECT_EQ(uneven.result->count(), 2u);
}

}  // namespace
}  // namespace walkcycle
