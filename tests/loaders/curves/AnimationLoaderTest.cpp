#include <string>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/curves/AnimationLoader.h"

namespace walkcycle {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::SizeIs;

Model boxMoved(const std::string& stack, const AnimationText& animation) {
    return loadText(boxWith(stack, animations(animation.text())));
}

TEST(AnimationLoaderTest, aDocumentWithoutAnimationsHasNoClip) {
    const Model model = loadText(boxWith("", ""));
    EXPECT_THAT(model.animations, IsEmpty());
    EXPECT_EQ(model.exactMotion, nullptr);
}

TEST(AnimationLoaderTest, theWholeTimelineIsAClipNamedAfterTheFile) {
    const Model model = boxMoved("<translate sid='t'>0 0 0</translate>", {"box/t.Y", "0.5 2", "1 4"});
    ASSERT_THAT(model.animations, SizeIs(1));
    EXPECT_EQ(model.animations[0].name, "test");
    EXPECT_DOUBLE_EQ(model.animations[0].startSeconds, 0.5);
    EXPECT_DOUBLE_EQ(model.animations[0].endSeconds, 2.0);
}

struct TargetCase {
    const char* stack;
    const char* target;
    const char* values;
    const char* params;
    glm::vec4 point;     // of the box
    glm::vec3 expected;  // where it is at 1 second, half way
};

class TargetTest : public testing::TestWithParam<TargetCase> {};

TEST_P(TargetTest, movesWhatItNames) {
    const TargetCase& c = GetParam();
    AnimationText animation{c.target, "0 2", c.values};
    animation.params = c.params;
    const Model model = boxMoved(c.stack, animation);
    EXPECT_THAT(codes(model.diagnostics), IsEmpty());
    ASSERT_THAT(model.animations, SizeIs(1));
    const glm::vec3 keyedPoint(keyed(model, 1.0) * c.point);
    const glm::vec3 exactPoint(exactLocal(model, 1.0) * glm::dvec4(c.point));
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(keyedPoint[i], c.expected[i], 1e-4);
        EXPECT_NEAR(exactPoint[i], c.expected[i], 1e-6);
    }
}

const glm::vec4 kOrigin{0, 0, 0, 1}, kX{1, 0, 0, 1};
INSTANTIATE_TEST_SUITE_P(
    Forms, TargetTest,
    testing::Values(
        TargetCase{"<translate sid='t'>9 0 0</translate>", "box/t", "0 0 0 2 4 6", "XYZ", kOrigin, {1, 2, 3}},
        TargetCase{"<translate sid='t'>9 0 0</translate>", "box/t.Y", "0 4", "X", kOrigin, {9, 2, 0}},
        TargetCase{"<translate sid='t'>9 0 0</translate>", "box/t(2)", "0 4", "X", kOrigin, {9, 0, 2}},
        TargetCase{"<translate sid='a.b-c'>9 0 0</translate>", "box/a.b-c.X", "0 4", "X", kOrigin, {2, 0, 0}},
        TargetCase{
            "<translate sid='a.X'>9 0 0</translate>", "box/a.X", "0 0 0 0 4 0", "XYZ", kOrigin, {0, 2, 0}},
        TargetCase{"<rotate sid='r'>0 0 1 0</rotate>", "box/r.ANGLE", "0 180", "X", kX, {0, 1, 0}},
        TargetCase{"<rotate sid='r'>0 0 1 0</rotate>", "box/r(3)", "0 180", "X", kX, {0, 1, 0}},
        TargetCase{"<rotate sid='r'>0 0 1 0</rotate>", "box/r", "0 180", "X", kX, {0, 1, 0}},
        TargetCase{"<rotate sid='r'>0 0 1 0</rotate>", "box/r", "0 1 0 0 0 1 0 180", "XYZW", kX, {0, 0, -1}},
        TargetCase{"<scale sid='s'>1 1 1</scale>", "box/s.X", "1 5", "X", kX, {3, 0, 0}},
        TargetCase{"<matrix sid='m'>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>",
                   "box/m(3)(1)",
                   "0 4",
                   "X",
                   kOrigin,
                   {0, 2, 0}},
        TargetCase{"<matrix sid='m'>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>",
                   "box/m",
                   "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 2 0 1 0 4 0 0 1 6 7 7 7 7",
                   "M",
                   kOrigin,
                   {1, 2, 3}},
        TargetCase{
            "<lookat sid='l'>0 0 0 0 0 -1 0 1 0</lookat>", "box/l(0)", "0 4", "X", kOrigin, {2, 0, 0}}));

TEST(AnimationLoaderTest, sidPathsGoThroughChildNodes) {
    const Model model = loadText(
        collada(triangle() + animations(AnimationText{"root/arm/hand/t.X", "0 2", "0 4"}.text()) +
                scene("<node id='root'><node sid='arm'><node sid='hand'><translate sid='t'>0 0 0</translate>"
                      "<instance_geometry url='#mesh'/></node></node></node>")));
    ASSERT_THAT(model.skeleton.joints, SizeIs(3));
    EXPECT_NEAR(keyed(model, 1.0, 2)[3].x, 2.0f, 1e-4);
}

TEST(AnimationLoaderTest, aChannelOnANodeMovesAllItsOccurrences) {
    const Model model = loadText(
        collada(triangle() + animations(AnimationText{"leg/t.X", "0 2", "0 4"}.text()) +
                "<library_nodes><node id='leg'><translate sid='t'>0 0 0</translate></node></library_nodes>" +
                scene("<node id='a'><instance_node url='#leg'/></node><node id='b'><instance_node "
                      "url='#leg'/></node>")));
    ASSERT_THAT(model.animations.at(0).channels, SizeIs(2));
    EXPECT_NEAR(exactLocal(model, 1.0, 1)[3].x, 2.0, 1e-9);
    EXPECT_NEAR(exactLocal(model, 1.0, 3)[3].x, 2.0, 1e-9);
}

TEST(AnimationLoaderTest, targetsThatLeadNowhereAreReportedWithWhatWasLookedFor) {
    const std::string text = boxWith(
        "<translate sid='t'>0 0 0</translate>",
        animations(
            AnimationText{"ball/t.X", "0 1", "0 1"}.text() + "\n" +
            AnimationText{.target = "box/r.X", .times = "0 1", .values = "0 1", .id = "b"}.text() + "\n" +
            AnimationText{.target = "box/t.ANGLES", .times = "0 1", .values = "0 1", .id = "c"}.text()));
    const Model model = loadText(text);
    EXPECT_THAT(codes(model.diagnostics), testing::ElementsAre("WC0507", "WC0507", "WC0509"));
    EXPECT_THAT(model.diagnostics[0].message, testing::HasSubstr("ball"));
    EXPECT_EQ(model.diagnostics[1].line, lineOf(text, "box/r.X"));
    EXPECT_THAT(model.animations, IsEmpty());
}

TEST(AnimationLoaderTest, animationsNestAndBorrowSamplersAndSources) {
    const AnimationText x{.target = "box/t.X", .times = "0 2", .values = "0 4", .id = "x"};
    const AnimationText y{.target = "box/t.Y", .times = "0 2", .values = "0 8", .id = "y"};
    const Model model = loadText(boxWith(
        "<translate sid='t'>0 0 0</translate>",
        animations("<animation>" + x.channel() + "<animation>" + y.sources() + "</animation>" + y.channel() +
                   "<channel source='#x-sampler' target='box/t.Z'/></animation>"
                   "<animation><animation>" +
                   x.sources() + x.sampler() + y.sampler() + "</animation></animation>")));
    EXPECT_THAT(codes(model.diagnostics), IsEmpty());
    const glm::dmat4 local = exactLocal(model, 1.0);
    EXPECT_EQ(glm::dvec3(local[3]), glm::dvec3(2, 4, 2));
}

TEST(AnimationLoaderTest, twoChannelsOnOneTargetAreReportedAndTheLastCounts) {
    const AnimationText first{.target = "box/t.X", .times = "0 2", .values = "0 4", .id = "x"};
    const AnimationText second{.target = "box/t.X", .times = "0 2", .values = "0 8", .id = "y"};
    const Model model =
        loadText(boxWith("<translate sid='t'>0 0 0</translate>", animations(first.text() + second.text())));
    EXPECT_THAT(codes(model.diagnostics), Contains("WC0511"));
    EXPECT_DOUBLE_EQ(exactLocal(model, 1.0)[3].x, 4.0);
}

TEST(AnimationLoaderTest, infinityFromMayasTechniqueGoesOnWithinTheTimeline) {
    const AnimationText cycling{.target = "box/t.X",
                                .times = "0 1",
                                .values = "0 4",
                                .id = "x",
                                .inputExtra =
                                    "<technique profile='MAYA'><pre_infinity>CONSTANT</pre_infinity>"
                                    "<post_infinity>CYCLE</post_infinity></technique>"};
    const AnimationText longer{.target = "box/t.Y", .times = "0 4", .values = "0 8", .id = "y"};
    const Model model =
        loadText(boxWith("<translate sid='t'>0 0 0</translate>", animations(cycling.text() + longer.text())));
    EXPECT_NEAR(exactLocal(model, 2.75)[3].x, 3.0, 1e-9);
    EXPECT_NEAR(keyed(model, 2.75)[3].x, 3.0, 1e-3);
    EXPECT_NEAR(keyed(model, 3.1)[3].x, 0.4, 1e-3);
}

TEST(AnimationLoaderTest, clipsPlayOnlyTheirOwnAnimationsBetweenTheirTimes) {
    const AnimationText x{.target = "box/t.X", .times = "0 1 2", .values = "0 4 0", .id = "x"};
    const AnimationText y{.target = "box/t.Y", .times = "0 2", .values = "0 8", .id = "y"};
    const Model model = loadText(boxWith(
        "<translate sid='t'>0 0 5</translate>",
        animations(x.text() + y.text()) +
            "<library_animation_clips><animation_clip name='sway' start='0.5' end='1.5'><instance_animation "
            "url='#x'/>"
            "</animation_clip><animation_clip id='rise'><instance_animation url='#y'/></animation_clip>"
            "<animation_clip id='none'/></library_animation_clips>"));
    EXPECT_THAT(codes(model.diagnostics), testing::ElementsAre("WC0512"));
    ASSERT_THAT(model.animations, SizeIs(3));
    EXPECT_EQ(model.animations[1].name, "sway");
    EXPECT_DOUBLE_EQ(model.animations[1].startSeconds, 0.5);
    EXPECT_DOUBLE_EQ(model.animations[1].endSeconds, 1.5);
    EXPECT_NEAR(glm::distance(glm::vec3(keyed(model, 1.0, 0, 1)[3]), glm::vec3(4, 0, 5)), 0.0f, 1e-3);
    EXPECT_NEAR(glm::distance(glm::vec3(keyed(model, 1.0, 0, 2)[3]), glm::vec3(0, 4, 5)), 0.0f, 1e-3);
    EXPECT_NEAR(glm::distance(glm::vec3(keyed(model, 1.0, 0, 0)[3]), glm::vec3(4, 4, 5)), 0.0f, 1e-3);
}

}  // namespace
}  // namespace walkcycle
