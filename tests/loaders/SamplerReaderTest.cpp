#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/SamplerReader.h"

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

}  // namespace
}  // namespace walkcycle
