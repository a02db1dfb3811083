#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/curves/Motion.h"

namespace walkcycle {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

const std::string kMove = "<translate sid='t'>0 0 0</translate>";
const std::string kMatrix = "<matrix sid='m'>" + kIdentity + "</matrix>";
const std::string kRaised = "1 0 0 0 0 1 0 4 0 0 1 0 0 0 0 1 ";

Model boxMoved(const std::string& stack, const std::string& body) {
    return loadText(boxWith(stack, animations(body)));
}

std::string infinity(const std::string& before, const std::string& after) {
    return "<technique profile='MAYA'><pre_infinity>" + before + "</pre_infinity><post_infinity>" + after +
           "</post_infinity></technique>";
}

// Keeps the timeline longer than what is looked at.
const AnimationText kLonger{.target = "box/t.Z", .times = "-4 4", .values = "0 8", .id = "longer"};

TEST(MotionTest, channelsOneAfterTheOtherTakeOverAtTheirFirstKeyAndAreNoRivals) {
    const AnimationText first{.target = "box/t.X", .times = "0 1", .values = "0 1", .id = "x"};
    const AnimationText second{.target = "box/t.X", .times = "2 3", .values = "5 6", .id = "y"};
    for (const std::string& body : {first.text() + second.text(), second.text() + first.text()}) {
        const Model model = boxMoved(kMove, body);
        EXPECT_THAT(codes(model.diagnostics), IsEmpty());
        EXPECT_NEAR(exactLocal(model, 1.9)[3].x, 1.0, 1e-9);
        EXPECT_NEAR(keyed(model, 1.9)[3].x, 1.0f, 1e-3f);
        EXPECT_NEAR(keyed(model, 2.0)[3].x, 5.0f, 1e-3f);
        EXPECT_NEAR(keyed(model, 2.5)[3].x, 5.5f, 1e-3f);
    }
}

TEST(MotionTest, channelsOfDifferentNumbersAreNoRivalsInAnyOrder) {
    const AnimationText x{.target = "box/t.X", .times = "0 2", .values = "0 4", .id = "x"};
    const AnimationText y{.target = "box/t.Y", .times = "0 2", .values = "0 8", .id = "y"};
    const Model model = boxMoved(kMove, y.text() + x.text());
    EXPECT_THAT(codes(model.diagnostics), IsEmpty());
    EXPECT_NEAR(glm::distance(glm::dvec3(exactLocal(model, 1.0)[3]), glm::dvec3(2, 4, 0)), 0.0, 1e-9);
}

// Rivals need not stand side by side, neither in the file nor in the order of their first keys.
TEST(MotionTest, aChannelTakesOverFromItsRivalWhateverStandsBetweenThem) {
    const AnimationText x{.target = "box/t.X", .times = "0 1", .values = "0 1", .id = "x"};
    const AnimationText y{.target = "box/t.Y", .times = "0.5 1", .values = "0 2", .id = "y"};
    const AnimationText laterX{.target = "box/t.X", .times = "2 3", .values = "5 6", .id = "x2"};
    const AnimationText laterY{.target = "box/t.Y", .times = "3 4", .values = "7 8", .id = "y2"};
    const Model model = boxMoved(kMove, x.text() + y.text() + laterX.text() + laterY.text());
    EXPECT_NEAR(exactLocal(model, 1.9)[3].x, 1.0, 1e-9);
    EXPECT_NEAR(exactLocal(model, 2.5)[3].x, 5.5, 1e-9);
    EXPECT_NEAR(exactLocal(model, 2.9)[3].y, 2.0, 1e-9);
    EXPECT_NEAR(exactLocal(model, 3.5)[3].y, 7.5, 1e-9);
}

TEST(MotionTest, ofThreeRivalsEachCountsFromItsFirstKeyOn) {
    std::string body;
    for (const std::string n : {"0", "1", "2"})
        body +=
            AnimationText{
                .target = "box/t.X", .times = n + " " + n + ".5", .values = n + " " + n, .id = "x" + n}
                .text();
    const Model model = boxMoved(kMove, body);
    for (const double seconds : {0.7, 1.7, 2.2})
        EXPECT_NEAR(exactLocal(model, seconds)[3].x, std::floor(seconds), 1e-9) << seconds;
}

TEST(MotionTest, ofMoreRivalsThanAnyHonestFileHasTheLastCounts) {
    const AnimationText one{.target = "box/t.X", .times = "0 1", .values = "0 1", .id = "x"};
    const AnimationText last{.target = "box/t.X", .times = "5 6", .values = "7 8", .id = "y"};
    std::string many = last.sources() + last.sampler() + one.sources() + one.sampler();
    for (int i = 0; i < 1001; ++i) many += one.channel();
    const Model model = boxMoved(kMove, "<animation>" + many + last.channel() + "</animation>");
    EXPECT_THAT(codes(model.diagnostics), Contains("WC0511"));
    EXPECT_NEAR(exactLocal(model, 0.5)[3].x, 7.0, 1e-9);
}

TEST(MotionTest, aMatrixThatGoesOnStraightIsKeyedAsFarAsTheTimelineGoes) {
    for (const char* beyond : {"LINEAR", "CYCLE_RELATIVE"}) {
        AnimationText matrix{.target = "box/m", .times = "0 1", .values = kIdentity + kRaised, .params = "M"};
        matrix.inputExtra = infinity(beyond, beyond);
        const Model model = boxMoved(kMatrix + kMove, matrix.text() + kLonger.text());
        const Model alone = boxMoved(kMatrix, matrix.text());
        for (const double seconds : {-3.25, -1.0, 0.5, 3.5})
            EXPECT_NEAR(keyed(model, seconds)[3].y, 4.0 * seconds, 1e-3) << beyond << " " << seconds;
        EXPECT_NEAR(keyed(alone, 0.5)[3].y, 2.0f, 1e-3f);
    }
}

TEST(MotionTest, aMatrixOnBezierKeysGoesByItsNumbers) {
    AnimationText matrix{.target = "box/m", .times = "0 1", .values = kIdentity + kRaised, .params = "M"};
    matrix.interpolations = "BEZIER";
    matrix.tangentParams = "ABCDEFGHIJKLMNOP";
    matrix.outTangents = kIdentity + kIdentity;
    matrix.inTangents = kRaised + kRaised;
    const Model model = boxMoved(kMatrix, matrix.text());
    EXPECT_EQ(codes(model.diagnostics), std::vector<std::string>{"WC0120"}) << "tangents of one number";
    EXPECT_NEAR(exactLocal(model, 0.25)[3].y, 0.625, 1e-9);
    EXPECT_NEAR(keyed(model, 0.25)[3].y, 0.625f, 1e-3f);
}

TEST(MotionTest, aMatrixBelowAnAssetOfItsOwnIsKeyedInTheDocumentsUnits) {
    AnimationText matrix{.target = "inch/m", .times = "0 1", .values = kIdentity + kRaised, .params = "M"};
    const Model model = loadText(collada(triangle() + animations(matrix.text()) +
                                         scene("<node id='inch'><asset><unit meter='0.0254'/></asset>" +
                                               kMatrix + "<instance_geometry url='#mesh'/></node>")));
    EXPECT_NEAR(keyed(model, 0.5)[3].y, 2 * 0.0254, 1e-5);
}

TEST(MotionTest, oneNumberOfAMatrixMayComeFromAWholeMatrix) {
    AnimationText matrix{
        .target = "box/m(3)(1)", .times = "0 1", .values = kIdentity + kRaised, .params = "M"};
    const Model model = boxMoved(kMatrix, matrix.text());
    EXPECT_THAT(codes(model.diagnostics), IsEmpty());
    EXPECT_NEAR(exactLocal(model, 0.5)[3].y, 2.0, 1e-9);
    EXPECT_NEAR(keyed(model, 0.5)[3].y, 2.0f, 1e-3f);
}

TEST(MotionTest, theAxisOfARotationMovesToo) {
    const Model model =
        boxMoved("<rotate sid='r'>1 0 0 180</rotate>", AnimationText{"box/r.Y", "0 1", "0 1"}.text());
    // About (1, 0, 0) first, about the diagonal of x and y at last: that swaps them.
    EXPECT_THAT(glm::vec3(keyed(model, 0.0) * glm::vec4(1, 0, 0, 1)), isAt(1, 0, 0));
    EXPECT_NEAR(glm::distance(glm::vec3(keyed(model, 1.0) * glm::vec4(1, 0, 0, 1)), glm::vec3(0, 1, 0)), 0.0,
                1e-3);
    EXPECT_LT(largestError(model), 2e-4);
}

TEST(MotionTest, aShorterListGetsWhatFitsIntoIt) {
    const Model model = boxMoved(kMove, AnimationText{"box/t.X", "0 2", "0 4"}.text());
    model.exactMotion->evaluate(1.0, {}, {});
    std::vector<glm::dmat4> locals(model.skeleton.joints.size() + 2, glm::dmat4(7.0));
    model.exactMotion->evaluate(1.0, locals, {});
    EXPECT_DOUBLE_EQ(locals[0][3].x, 2.0);
    EXPECT_EQ(locals.back(), glm::dmat4(7.0));
}

}  // namespace
}  // namespace walkcycle
