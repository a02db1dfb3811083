#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/curves/CurveBuilder.h"
#include "loaders/keys/KeyFrameFitter.h"

namespace walkcycle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

// The triangle is 1 by 1: its size is the square root of 2, and the default tolerance 1e-4 of that.
constexpr double kAllowed = 1.5e-4;
const char* const kRotate = "<rotate sid='r'>0 0 1 0</rotate>";

Model boxMoved(const std::string& stack, const std::string& body) {
    return loadText(boxWith(stack, animations(body)));
}

std::size_t keyCount(const Model& model) {
    std::size_t count = 0;
    for (const Channel& channel : model.animations.at(0).channels)
        count += channel.keyFrames.size() + channel.matrixKeyFrames.size();
    return count;
}

TEST(KeyFrameFitterTest, straightMotionKeepsTheFilesOwnKeys) {
    const Model model =
        boxMoved("<translate sid='t'>0 0 0</translate>", AnimationText{"box/t.X", "0 1 3", "0 4 5"}.text());
    const Channel& channel = model.animations.at(0).channels.at(0);
    ASSERT_THAT(channel.keyFrames, SizeIs(3));
    EXPECT_THAT(channel.tangents, IsEmpty());
    EXPECT_EQ(channel.keyFrames[1].seconds, 1.0);
    EXPECT_EQ(channel.keyFrames[1].transform.position.x, 4.0f);
}

TEST(KeyFrameFitterTest, keysThatTheirNeighboursReproduceAreLeftOut) {
    const Model model = boxMoved("<translate sid='t'>0 0 0</translate>",
                                 AnimationText{"box/t.X", "0 1 2 3 4", "0 1 2 3 0"}.text());
    EXPECT_EQ(keyCount(model), 3u);
}

TEST(KeyFrameFitterTest, aFullTurnInTwoKeysTurnsAllTheWay) {
    for (const char* angles : {"0 360", "0 -360", "0 1440", "90 720"}) {
        const Model model = boxMoved(kRotate, AnimationText{"box/r.ANGLE", "0 2", angles}.text());
        EXPECT_LT(largestError(model), kAllowed) << angles;
    }
}

TEST(KeyFrameFitterTest, neighbouringRotationsAreOnOneSideOfTheSphere) {
    const std::string stack = std::string(kRotate) + "<rotate sid='y'>0 1 0 0</rotate>";
    const Model model = boxMoved(
        stack,
        AnimationText{.target = "box/r.ANGLE", .times = "0 2", .values = "0 1200", .id = "r"}.text() +
            AnimationText{.target = "box/y.ANGLE", .times = "0 2", .values = "0 -900", .id = "y"}.text());
    const std::vector<KeyFrame>& keys = model.animations.at(0).channels.at(0).keyFrames;
    for (std::size_t i = 1; i < keys.size(); ++i)
        EXPECT_GE(glm::dot(keys[i - 1].transform.rotation, keys[i].transform.rotation), 0.0f) << i;
}

// A curve of a box: rises a little in the first second, and by much in the second one.
JointMotion risingMotion(const Curve& curve) {
    JointMotion motion;
    motion.stack.push_back({TransformElement::Kind::Translate, {}});
    motion.bindings.push_back({.curve = &curve, .count = 1});
    return motion;
}

Curve risingCurve(double first, double second) {
    return makeCurve({.width = 1,
                      .times = {0, 1, 2},
                      .values = {0, first, first + second},
                      .interpolations = std::vector<Interpolation>(3, Interpolation::Bezier),
                      .tangentWidth = 2,
                      .inTangents = {0, 0, 0.05, first, 1.05, first + second},
                      .outTangents = {0.95, 0, 1.95, first, 0, 0}});
}

double largestError(const JointMotion& motion, const Channel& channel, double from, double to) {
    double most = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const double t = from + (to - from) * i / 1000.0;
        most = std::max(most, std::abs(motion.localTransform(t)[3].x - sample(channel, t).position.x));
    }
    return most;
}

// Depth first, the first second took all keys.
TEST(KeyFrameFitterTest, ifKeysRunOutTheyHaveGoneWhereTheyHelpMost) {
    const Tolerance fine{.budget = 1e-9};
    for (const auto& [first, second] : {std::pair(0.01, 10.0), std::pair(10.0, 0.01)}) {
        const Curve curve = risingCurve(first, second);
        const JointMotion motion = risingMotion(curve);
        const auto errorOf = [&](std::size_t most) {
            const Channel channel = fitChannel(motion, {0, 1, 2}, fine, {.most = most});
            EXPECT_LE(channel.keyFrames.size(), most);
            return largestError(motion, channel, 0.0, 2.0);
        };
        double before = 1e300;
        for (const std::size_t most : {3u, 6u, 12u, 24u, 48u, 96u}) {
            const double error = errorOf(most);
            EXPECT_LE(error, before) << most;
            before = error;
        }
        EXPECT_LT(errorOf(24), 0.02);
        EXPECT_LT(errorOf(96), 1e-4);
    }
}

// With few keys the tolerance says nothing any more: the search splits the same pieces in the same order.
TEST(KeyFrameFitterTest, ifKeysRunOutASmallerToleranceGivesTheSameKeys) {
    const Curve curve = risingCurve(1.0, 10.0);
    const JointMotion motion = risingMotion(curve);
    const Channel fine = fitChannel(motion, {0, 1, 2}, {.budget = 1e-7}, {.most = 40});
    const Channel finer = fitChannel(motion, {0, 1, 2}, {.budget = 1e-9}, {.most = 40});
    ASSERT_EQ(fine.keyFrames.size(), finer.keyFrames.size());
    for (std::size_t i = 0; i < fine.keyFrames.size(); ++i)
        EXPECT_EQ(fine.keyFrames[i].seconds, finer.keyFrames[i].seconds);
}

TEST(KeyFrameFitterTest, keysStandInTheOrderOfTime) {
    const Curve curve = risingCurve(5.0, 10.0);
    const Channel channel = fitChannel(risingMotion(curve), {0, 1, 2}, {.budget = 1e-6});
    ASSERT_GT(channel.keyFrames.size(), 20u);
    for (std::size_t i = 1; i < channel.keyFrames.size(); ++i)
        EXPECT_LT(channel.keyFrames[i - 1].seconds, channel.keyFrames[i].seconds);
    EXPECT_LT(largestError(risingMotion(curve), channel, 0.0, 2.0), 2e-6);
}

// Matrices that keep a little shear need many keys for a rotation, and transforms without it are nearer than few matrices.
TEST(KeyFrameFitterTest, ofTooFewMatricesAndTransformsWithoutShearTheNearerOnesAreTaken) {
    const auto rotated = [](double degrees, double shear) {
        const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
        return std::vector<double>{c, -s + c * shear, 0, 0, s, c + s * shear, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    };
    CurveKeys keys{.width = 16,
                   .times = {0, 1},
                   .values = rotated(0, 1e-6),
                   .interpolations = std::vector<Interpolation>(2, Interpolation::Linear),
                   .inTangents = {},
                   .outTangents = {}};
    for (const double number : rotated(170, 1e-6)) keys.values.push_back(number);
    const Curve curve = makeCurve(keys);
    JointMotion motion;
    motion.stack.push_back({TransformElement::Kind::Matrix, {}});
    motion.bindings.push_back({.curve = &curve, .count = 16});
    const Channel few = fitChannel(motion, {0, 1}, {.budget = 1e-7}, {.most = 40});
    EXPECT_THAT(few.keyFrames, SizeIs(2));
    const Channel many = fitChannel(motion, {0, 1}, {.budget = 1e-7});
    EXPECT_THAT(many.keyFrames, IsEmpty());
    EXPECT_GT(many.matrixKeyFrames.size(), 1000u);
}

// 1000 degrees, with eight keys between the ends at most: one less, and a way would be longer than half a circle.
TEST(KeyFrameFitterTest, aLongRotationSpreadsTheKeysThatItMayHave) {
    const Curve curve = makeCurve({.width = 1,
                                   .times = {0, 1},
                                   .values = {0, 1000},
                                   .interpolations = std::vector<Interpolation>(2, Interpolation::Linear),
                                   .inTangents = {},
                                   .outTangents = {}});
    JointMotion motion;
    motion.stack.push_back({TransformElement::Kind::Rotate, {0, 0, 1, 0}});
    motion.bindings.push_back({.curve = &curve, .first = 3, .count = 1});
    const Channel channel = fitChannel(motion, {0, 1}, {.budget = 1e-4}, {.most = 10});
    ASSERT_THAT(channel.keyFrames, SizeIs(9));
    for (int i = 0; i <= 100; ++i)
        EXPECT_LT(apart(sample(channel, i / 100.0).toMatrix(), glm::mat4(motion.localTransform(i / 100.0))),
                  1e-4)
            << i;
}

TEST(KeyFrameFitterTest, mixedEulerAnglesStayWithinTheTolerance) {
    const std::string stack =
        "<rotate sid='z'>0 0 1 0</rotate><rotate sid='y'>0 1 0 0</rotate><rotate sid='x'>1 0 0 0</rotate>";
    const Model model = boxMoved(
        stack,
        AnimationText{.target = "box/z.ANGLE", .times = "0 1 2", .values = "0 70 -20", .id = "z"}.text() +
            AnimationText{.target = "box/y.ANGLE", .times = "0 0.7 2", .values = "10 -50 60", .id = "y"}
                .text() +
            AnimationText{.target = "box/x.ANGLE", .times = "0 2", .values = "0 150", .id = "x"}.text());
    EXPECT_LT(largestError(model), kAllowed);
    EXPECT_LE(model.animations[0].achievedError, 1e-4f);
    EXPECT_LT(keyCount(model), 60u) << "as many as 30 Hz";
}

// One angle on straight lines is known to rotate evenly, unless it swings a translation around, or there are two of them.
TEST(KeyFrameFitterTest, anAngleBetweenShiftsAndScalesStaysWithinTheTolerance) {
    const std::string shift = "<translate sid='t'>1 2 3</translate>";
    const std::string scale = "<scale sid='s'>1 2 3</scale>";
    const std::string angle =
        AnimationText{.target = "box/r.ANGLE", .times = "0 1 3", .values = "0 170 -40"}.text();
    const std::string shifts =
        AnimationText{.target = "box/t.X", .times = "0 2 3", .values = "0 4 1", .id = "shift"}.text();
    const std::string scales =
        AnimationText{.target = "box/s.Y", .times = "0 2 3", .values = "1 3 -2", .id = "scale"}.text();
    for (const std::string& stack :
         {shift + kRotate, shift + kRotate + scale, kRotate + shift + scale, shift + scale + kRotate})
        for (const std::string& body : {angle, angle + shifts, angle + scales, angle + shifts + scales}) {
            const Model model = boxMoved(stack, body);
            EXPECT_LT(largestError(model), 3 * kAllowed) << stack << body;
        }
    EXPECT_EQ(keyCount(boxMoved(shift + kRotate, angle)),
              4u);  // the rotation by 210 degrees takes one between
}

TEST(KeyFrameFitterTest, smoothCurvesTakeFewerKeysThanThirtyAFrameRate) {
    AnimationText swing{"box/r.ANGLE", "0 1 2 3 4", "0 40 0 -40 0"};
    swing.interpolations = "BEZIER";
    swing.outTangents = "0.33 0 1.33 40 2.33 0 3.33 -40 4.33 0";
    swing.inTangents = "-0.33 0 0.67 40 1.67 0 2.67 -40 3.67 0";
    const Model model = boxMoved(kRotate, swing.text());
    EXPECT_LT(largestError(model), kAllowed);
    EXPECT_LT(keyCount(model), 40u);
}

TEST(KeyFrameFitterTest, curvesGetKeysWhereTheyAreSteep) {
    AnimationText snap{"box/t.X", "0 1", "0 4"};
    snap.interpolations = "BEZIER";
    snap.outTangents = "0.99 0 0 0";
    snap.inTangents = "0 0 0.01 4";
    const Model model = boxMoved("<translate sid='t'>0 0 0</translate>", snap.text());
    EXPECT_LT(largestError(model), kAllowed);
    EXPECT_LE(model.animations[0].achievedError, 1e-4f);
}

TEST(KeyFrameFitterTest, bakedKeysOfASmoothCurveBecomeFewer) {
    std::string times, values;
    for (int i = 0; i <= 120; ++i) {
        times += std::to_string(i / 30.0) + " ";
        values += std::to_string(30.0 * std::sin(i / 30.0)) + " ";
    }
    const Model model = boxMoved(kRotate, AnimationText{"box/r.ANGLE", times, values}.text());
    EXPECT_LT(largestError(model), kAllowed);
    EXPECT_LT(keyCount(model), 121u);
}

TEST(KeyFrameFitterTest, stepsStaySteps) {
    AnimationText blink{"box/t.X", "0 1 2 3", "0 4 4 1"};
    blink.interpolations = "STEP";
    const Model model = boxMoved("<translate sid='t'>0 0 0</translate>", blink.text());
    const std::vector<KeyFrame>& keys = model.animations.at(0).channels.at(0).keyFrames;
    ASSERT_THAT(keys, SizeIs(3));
    EXPECT_TRUE(keys[0].step && keys[1].step);
    EXPECT_EQ(keyed(model, 0.999)[3].x, 0.0f);
    EXPECT_EQ(keyed(model, 1.0)[3].x, 4.0f);
    EXPECT_EQ(keyed(model, 3.0)[3].x, 1.0f);
}

TEST(KeyFrameFitterTest, aStepBesideALineJumpsWhereItSteps) {
    AnimationText blink{
        .target = "box/t.X", .times = "0 1 2", .values = "0 4 1", .interpolations = "STEP", .id = "x"};
    const Model model = boxMoved(
        "<translate sid='t'>0 0 0</translate>",
        blink.text() + AnimationText{.target = "box/t.Y", .times = "0 2", .values = "0 2", .id = "y"}.text());
    EXPECT_LT(largestError(model), kAllowed);
    EXPECT_THAT(model.animations.at(0).channels.at(0).keyFrames, SizeIs(5));
}

TEST(KeyFrameFitterTest, stepsBetweenLinesAndCurvesKeepTheirKinds) {
    AnimationText mixed{"box/r.ANGLE", "0 1 2 3", "0 90 -45 20"};
    mixed.interpolations = "LINEAR STEP BEZIER LINEAR";
    mixed.outTangents = "0 0 0 0 2.3 60 0 0";
    mixed.inTangents = "0 0 0 0 0 0 2.9 -80";
    const Model model = boxMoved(kRotate, mixed.text());
    EXPECT_LT(largestError(model), kAllowed);
}

TEST(KeyFrameFitterTest, shearMirroringAndFlatteningBecomeMatrixKeys) {
    const std::string sheared =
        "<rotate sid='r'>0 0 1 0</rotate><scale sid='s'>3 1 1</scale><rotate>0 0 1 45</rotate>";
    const Model shear = boxMoved(sheared, AnimationText{"box/s.Y", "0 1", "1 3"}.text());
    EXPECT_THAT(shear.animations.at(0).channels.at(0).keyFrames, IsEmpty());
    EXPECT_LT(largestError(shear), kAllowed);

    const Model mirror =
        boxMoved("<scale sid='s'>1 1 1</scale>", AnimationText{"box/s.X", "0 1", "1 -1"}.text());
    EXPECT_THAT(mirror.animations.at(0).channels.at(0).matrixKeyFrames, SizeIs(2));
    EXPECT_LT(largestError(mirror), kAllowed);

    const Model grow = boxMoved(
        std::string(kRotate) + "<scale sid='s'>1 1 1</scale>",
        AnimationText{.target = "box/s", .times = "0 1", .values = "0 0 0 1 1 1", .params = "XYZ", .id = "s"}
                .text() +
            AnimationText{.target = "box/r.ANGLE", .times = "0 1", .values = "0 90", .id = "r"}.text());
    EXPECT_LT(largestError(grow), kAllowed);
}

TEST(KeyFrameFitterTest, aConstantMirrorIsAJointTransform) {
    const Model model = boxMoved("<rotate sid='r'>0 0 1 0</rotate><scale>1 1 -1</scale>",
                                 AnimationText{"box/r.ANGLE", "0 1", "0 90"}.text());
    EXPECT_THAT(model.animations.at(0).channels.at(0).matrixKeyFrames, IsEmpty());
    EXPECT_LT(largestError(model), kAllowed);
}

TEST(KeyFrameFitterTest, aMillionTurnsBetweenTwoKeysCostNoMillionKeys) {
    const Model model = boxMoved(kRotate, AnimationText{"box/r.ANGLE", "0 1", "0 360000000"}.text());
    EXPECT_LT(model.animations.at(0).channels.at(0).keyFrames.size(), 10000u);
    ASSERT_EQ(model.diagnostics.size(), 1u);  // what that costs is said
    EXPECT_EQ(model.diagnostics[0].code, "WC0513");
}

TEST(KeyFrameFitterTest, aWiderToleranceTakesFewerKeys) {
    AnimationText swing{"box/r.ANGLE", "0 1", "0 80"};
    swing.interpolations = "CARDINAL";
    swing.times = "0 1 1.2 3", swing.values = "0 80 -60 5";
    const std::string text = boxWith(kRotate, animations(swing.text()));
    LoadOptions loose;
    loose.tolerance = 1e-2;
    EXPECT_LT(keyCount(loadText(text, loose)), keyCount(loadText(text)));
}

TEST(KeyFrameFitterTest, manyMovingJointsShareTheTolerance) {
    std::string open, close, channels;
    for (int i = 0; i < 12; ++i) {
        const std::string name = "j" + std::to_string(i);
        open += "<node id='" + name + "'><translate>0 1 0</translate><rotate sid='r'>0 0 1 0</rotate>";
        close += "</node>";
        AnimationText bend{.target = name + "/r.ANGLE",
                           .times = "0 1 2",
                           .values = "0 25 0",
                           .interpolations = "CARDINAL",
                           .id = "a" + name};
        channels += bend.text();
    }
    const Model model = loadText(collada(triangle() + animations(channels) +
                                         scene(open + "<instance_geometry url='#mesh'/>" + close)));
    EXPECT_LE(model.animations.at(0).achievedError, 1e-4f);
    EXPECT_GT(model.animations.at(0).achievedError, 0.0f);
}

}  // namespace
}  // namespace walkcycle
