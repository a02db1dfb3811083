#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/curves/SamplerReader.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct ReadCurve {
    explicit ReadCurve(const AnimationText& animation, const std::string& from = "",
                       const std::string& to = "")
        : load(collada(animations(replaced(animation.text(), from, to)))) {
        SamplerReader reader(load.context);
        index = reader.read(load.byId("anim-sampler"));
        if (index >= 0) curve = reader.curves()[static_cast<std::size_t>(index)];
        said = codes(load.diagnostics.all());
    }
    static std::string replaced(std::string text, const std::string& from, const std::string& to) {
        return from.empty() ? text : text.replace(text.find(from), from.size(), to);
    }
    double at(double seconds) const {
        std::vector<double> out(curve.width);
        curve.evaluate(seconds, Side::Right, out);
        return out[0];
    }

    TestLoad load;
    int index = -1;
    Curve curve;
    std::vector<std::string> said;
};

TEST(SamplerReaderTest, unknownAndMissingInterpolationsAreLinearAndReported) {
    AnimationText animation{"box/t.X", "0 2", "0 4"};
    animation.interpolations = "WOBBLE";
    EXPECT_THAT(ReadCurve(animation).said, ElementsAre("WC0504"));
    EXPECT_EQ(ReadCurve(animation).at(1.0), 2.0);
    animation.interpolations = "LINEAR";
    const ReadCurve missing(animation, "<input semantic='INTERPOLATION' source='#anim-how'/>", "");
    EXPECT_THAT(missing.said, ElementsAre("WC0505"));
    EXPECT_EQ(missing.at(1.0), 2.0);
}

TEST(SamplerReaderTest, bezierWithoutTangentsIsLinearAndReported) {
    AnimationText animation{"box/t.X", "0 2", "0 4"};
    animation.interpolations = "BEZIER";
    EXPECT_THAT(ReadCurve(animation).said, ElementsAre("WC0506"));
    EXPECT_EQ(ReadCurve(animation).at(1.0), 2.0);
}

TEST(SamplerReaderTest, timesThatDoNotRiseArePutInOrder) {
    const ReadCurve read(AnimationText{"box/t.X", "0 2 1", "0 4 1"});
    EXPECT_THAT(read.said, ElementsAre("WC0503"));
    EXPECT_EQ(read.at(1.0), 1.0);
    EXPECT_EQ(read.at(1.5), 2.5);
}

TEST(SamplerReaderTest, timesThatAreAllTheSameAreAJump) {
    const ReadCurve read(AnimationText{"box/t.X", "1 1 1", "0 4 9"});
    EXPECT_THAT(read.said, ElementsAre("WC0503"));
    EXPECT_EQ(read.at(0.0), 0.0);
    EXPECT_EQ(read.at(2.0), 9.0);
}

TEST(SamplerReaderTest, twoKeysAtOneTimeAreNoFault) {
    EXPECT_THAT(ReadCurve(AnimationText{"box/t.X", "0 1 1 2", "0 4 9 9"}).said, IsEmpty());
}

TEST(SamplerReaderTest, keysWithoutAValueAreLeftOutAndReported) {
    const ReadCurve read(AnimationText{"box/t.X", "0 1 2", "0 4"});
    EXPECT_THAT(read.said, ElementsAre("WC0502"));
    EXPECT_EQ(read.curve.times.size(), 2u);
}

TEST(SamplerReaderTest, aSamplerWithoutValuesPlaysNothing) {
    const ReadCurve read(AnimationText{"box/t.X", "0 1", "0 4"},
                         "<input semantic='OUTPUT' source='#anim-out'/>", "");
    EXPECT_THAT(read.said, ElementsAre("WC0501"));
    EXPECT_EQ(read.index, -1);
}

TEST(SamplerReaderTest, aTimeThatIsNoNumberIsReportedAndNotPassedOn) {
    const ReadCurve read(AnimationText{"box/t.X", "0 NaN 2", "0 4 8"});
    EXPECT_THAT(read.said, testing::Contains("WC0204"));
    EXPECT_TRUE(std::isfinite(read.at(1.0)));
}

TEST(SamplerReaderTest, infinityIsReadFromTechniqueExtraAndTheAttributesOf15) {
    AnimationText animation{"box/t.X", "0 2", "0 4"};
    animation.inputExtra =
        "<technique profile='MAYA'><pre_infinity>CYCLE</pre_infinity>"
        "<post_infinity>OSCILLATE</post_infinity></technique>";
    EXPECT_EQ(ReadCurve(animation).curve.before, Infinity::Cycle);
    EXPECT_EQ(ReadCurve(animation).curve.after, Infinity::Oscillate);
    animation.inputExtra =
        "<extra><technique profile='FCOLLADA'><post_infinity>LINEAR</post_infinity></technique></extra>";
    EXPECT_EQ(ReadCurve(animation).curve.after, Infinity::Linear);
    animation.inputExtra = "";
    const ReadCurve read(animation, "<sampler ", "<sampler post_behavior='CYCLE_RELATIVE' ");
    EXPECT_EQ(read.curve.after, Infinity::CycleRelative);
}

TEST(SamplerReaderTest, aSourceWithoutItsHashIsFoundAndOneThatIsNoSourceIsMissing) {
    AnimationText animation{"box/t.X", "0 2", "0 4"};
    animation.interpolations = "STEP";
    const ReadCurve bare(animation, "'#anim-how'", "'anim-how'");
    EXPECT_THAT(bare.said, IsEmpty());
    EXPECT_EQ(bare.at(1.0), 0.0);
    const ReadCurve wrong(animation, "'#anim-how'", "'#anim-sampler'");
    EXPECT_THAT(wrong.said, ElementsAre("WC0505"));
    EXPECT_EQ(wrong.at(1.0), 2.0);
}

TEST(SamplerReaderTest, fewerInterpolationsThanSegmentsLeaveTheRestLinearAndAreReported) {
    AnimationText animation{"box/t.X", "0 2 4", "0 4 8"};
    animation.interpolations = "STEP ";  // the space: one word that does not stand for all
    const ReadCurve read(animation);
    EXPECT_THAT(read.said, ElementsAre("WC0505"));
    EXPECT_EQ(read.at(1.0), 0.0);
    EXPECT_EQ(read.at(3.0), 6.0);
    const ReadCurve none(animation, ">STEP <", "> <");
    EXPECT_THAT(none.said, testing::Contains("WC0505"));
    EXPECT_EQ(none.at(1.0), 2.0);
}

TEST(SamplerReaderTest, whatHasNoTimesOrNoValuesPlaysNothingAndIsReported) {
    const AnimationText animation{"box/t.X", "0 1", "0 4"};
    struct Case {
        const char *from, *to, *missing;
    };
    for (const Case& c :
         {Case{"<input semantic='INPUT' source='#anim-in'/>", "", "INPUT"},
          Case{"count=\"2\">0 1</float_array>", "count=\"0\"/>", "INPUT"},
          Case{"count=\"2\">0 4</float_array>", "count=\"0\"/>", "OUTPUT"},
          Case{"<float_array id=\"anim-in-array\" count=\"2\">0 1</float_array>", "", "INPUT"},
          Case{"<float_array id=\"anim-out-array\" count=\"2\">0 4</float_array>", "", "OUTPUT"}}) {
        const ReadCurve read(animation, c.from, c.to);
        EXPECT_EQ(read.index, -1) << c.from;
        const Diagnostic& last = read.load.diagnostics.all().back();
        EXPECT_EQ(last.code, "WC0501");
        EXPECT_THAT(last.message, testing::HasSubstr(c.missing)) << c.from;
        EXPECT_THAT(last.message, testing::HasSubstr("anim-sampler"));
    }
}

TEST(SamplerReaderTest, ofTimesThatComeInPairsTheFirstCounts) {
    const ReadCurve read(AnimationText{"box/t.X", "0 2", "0 4"}, floatSource("anim-in", "0 2", "T"),
                         floatSource("anim-in", "0 7 2 7", "TU"));
    EXPECT_THAT(read.said, ElementsAre("WC0306"));
    EXPECT_EQ(read.at(1.0), 2.0);
}

TEST(SamplerReaderTest, aStrideThatWasForgottenIsMadeUpForInRotationsAndMatrices) {
    const ReadCurve rotation(AnimationText{"box/r", "0 2", "0 0 1 0 0 0 1 90"});
    EXPECT_EQ(rotation.curve.width, 4u);
    EXPECT_THAT(rotation.said, ElementsAre("WC0306"));
    const ReadCurve matrix(AnimationText{"box/m", "0 2", kIdentity + kIdentity});
    EXPECT_EQ(matrix.curve.width, 16u);
    EXPECT_EQ(matrix.at(1.0), 1.0);
}

TEST(SamplerReaderTest, aSingleKeyNeedsNoTangents) {
    AnimationText animation{"box/t.X", "1", "4"};
    animation.interpolations = "BEZIER";
    EXPECT_THAT(ReadCurve(animation).said, IsEmpty());
    EXPECT_EQ(ReadCurve(animation).at(0.0), 4.0);
}

TEST(SamplerReaderTest, tangentsThatDoNotFitTheKeysAreLeftOutAndReported) {
    AnimationText animation{"box/t.X", "0 2", "0 4"};
    animation.interpolations = "HERMITE";
    animation.tangentParams = "X";
    struct Case {
        const char *in, *out;
    };
    for (const Case& c : {Case{"0 0", ""}, Case{"0 0 0", "0 0 0"}, Case{"0 0 0 0 0 0", "0 0 0 0 0 0"},
                          Case{"0 0", "0 0 0 0"}}) {
        animation.inTangents = c.in, animation.outTangents = c.out;
        const ReadCurve read(animation);
        EXPECT_THAT(read.said, ElementsAre("WC0506")) << c.in;
        EXPECT_EQ(read.at(0.5), 1.0) << c.in;
    }
    animation.inTangents = animation.outTangents = "0 0";
    EXPECT_THAT(ReadCurve(animation).said, ElementsAre("WC0120"));
    EXPECT_EQ(ReadCurve(animation).at(0.5), 0.625);  // 4 (3 s^2 - 2 s^3)
}

TEST(SamplerReaderTest, tangentsOfVectorsHaveATimeEachOrOneForAllOrNone) {
    AnimationText animation{"box/t", "0 3", "0 0 0 3 3 3"};
    animation.params = "XYZ";
    animation.interpolations = "BEZIER";
    struct Case {
        const char *params, *in, *out;
    };
    for (const Case& c :
         {Case{"XYZ", "0 0 0 2 2 2", "1 1 1 0 0 0"}, Case{"TXYZ", "0 0 0 0 2 2 2 2", "1 1 1 1 0 0 0 0"},
          Case{"XYXYXY", "0 0 0 0 0 0 2 2 2 2 2 2", "1 1 1 1 1 1 0 0 0 0 0 0"}}) {
        animation.tangentParams = c.params, animation.inTangents = c.in, animation.outTangents = c.out;
        const ReadCurve read(animation);
        const bool isQuirk = std::string_view(c.params) == "XYZ";  // one number per value
        EXPECT_EQ(read.said, isQuirk ? std::vector<std::string>{"WC0120"} : std::vector<std::string>{})
            << c.params;
        EXPECT_NEAR(read.at(1.2), 1.2, 1e-12) << c.params;
    }
    animation.tangentParams = "XYXYX", animation.inTangents = animation.outTangents = "0 0 0 0 0 0 0 0 0 0";
    EXPECT_THAT(ReadCurve(animation).said, ElementsAre("WC0506"));
}

TEST(SamplerReaderTest, aTimeThatIsNamedMoreThanTwiceKeepsItsFirstAndLastKey) {
    const ReadCurve read(AnimationText{"box/t.X", "0 1 1 1 2", "0 4 5 8 9"});
    EXPECT_THAT(read.said, ElementsAre("WC0503"));
    EXPECT_THAT(read.load.diagnostics.all()[0].message, testing::HasSubstr("more than twice"));
    EXPECT_EQ(read.at(0.5), 2.0);
    EXPECT_EQ(read.at(1.5), 8.5);
}

TEST(SamplerReaderTest, twoKeysAtOneTimeAloneAreAJumpThatIsReported) {
    const ReadCurve read(AnimationText{"box/t.X", "1 1", "4 9"});
    EXPECT_THAT(read.said, ElementsAre("WC0503"));
    EXPECT_EQ(read.at(0.5), 4.0);
    EXPECT_EQ(read.at(1.5), 9.0);
}

TEST(SamplerReaderTest, ofKeysThatOnlySortingBringsTogetherTheFirstCounts) {
    const ReadCurve read(AnimationText{"box/t.X", "0 1 0 2", "3 4 99 5"});
    EXPECT_THAT(read.said, ElementsAre("WC0503"));
    EXPECT_EQ(read.at(0.5), 3.5);
    const ReadCurve jump(AnimationText{"box/t.X", "2 0 0 3", "4 99 2 5"});  // these stood together
    EXPECT_EQ(jump.at(1.0), 3.0);
}

TEST(SamplerReaderTest, aGradientOf15GoesOnStraight) {
    const ReadCurve read(AnimationText{"box/t.X", "0 2", "0 4"}, "<sampler ",
                         "<sampler pre_behavior='GRADIENT' post_behavior='CONSTANT' ");
    EXPECT_EQ(read.at(-1.0), -2.0);
    EXPECT_EQ(read.at(3.0), 4.0);
}

}  // namespace
}  // namespace walkcycle
