#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/keys/MotionReach.h"

namespace walkcycle {
namespace {

// A loaded document, and what its motion reaches.
struct Reach {
    explicit Reach(const std::string& text)
        : model(loadText(text)),
          motion(dynamic_cast<const Motion&>(*model.exactMotion)),
          reach(model, motion, motion.start()) {}

    Tolerance tolerance(int joint) const { return reach.tolerance(joint, 0.01); }
    // Of how far the farthest point that a joint moves hangs from it, in model space.
    double hanging(int joint) const { return tolerance(joint).reach * tolerance(joint).unit; }

    Model model;
    const Motion& motion;
    MotionReach reach;
};

const std::string kMove = "<translate sid='t'>0 0 0</translate>";
const std::string kDrawn = "<instance_geometry url='#mesh'/>";

// It moves, and goes nowhere.
std::string still(const std::string& target) {
    return AnimationText{
        .target = target, .times = "0 1", .values = "0 0", .id = "still-" + target.substr(0, 1)}
        .text();
}

std::string boxOf(const std::string& positions, const std::string& stack = kMove) {
    return collada(triangle("mesh", positions) + animations(still("box/t.X")) +
                   scene("<node id='box'>" + stack + kDrawn + "</node>"));
}

TEST(MotionReachTest, theSizeIsTheDiagonalOfTheBoxWhereverItStands) {
    const double diagonal = std::sqrt(1.0 + 4.0 + 9.0);
    EXPECT_NEAR(Reach(boxOf("3 4 5  4 6 8  3 4 5")).reach.modelSize(), diagonal, 1e-6);
    EXPECT_NEAR(Reach(boxOf("-3 -4 -5  -4 -6 -8  -3 -4 -5")).reach.modelSize(), diagonal, 1e-6);
    EXPECT_NEAR(Reach(boxOf("3 4 5  4 6 8  3 4 5", kMove + "<scale>2 2 2</scale>")).reach.modelSize(),
                2.0 * diagonal, 1e-6);
}

TEST(MotionReachTest, withoutAnythingDrawnTheJointsGiveTheSize) {
    const Reach bones(
        collada(animations(still("a/t.X")) + scene("<node id='a'>" + kMove + "<translate>5 5 5</translate>" +
                                                   "<node><translate>0 3 4</translate></node></node>")));
    EXPECT_NEAR(bones.reach.modelSize(), 5.0, 1e-6);
}

TEST(MotionReachTest, aModelOfOnePointHasTheSizeOfOneUnit) {
    EXPECT_EQ(Reach(boxOf("2 2 2 2 2 2 2 2 2")).reach.modelSize(), 1.0);
}

TEST(MotionReachTest, aJointReachesAsFarAsThePointsOfItsChildren) {
    const Reach arm(collada(triangle("mesh", "0 0 0  0 3 0  0 3 4") +
                            animations(still("a/t.X") + still("b/t.X")) +
                            scene("<node id='a'>" + kMove + "<node id='b'>" + kMove +
                                  "<translate>0 10 0</translate>" + kDrawn + "</node></node>")));
    EXPECT_NEAR(arm.hanging(1), 5.0, 1e-6);
    EXPECT_NEAR(arm.hanging(0), std::hypot(13.0, 4.0), 1e-6);
}

TEST(MotionReachTest, aJointWithNothingOnItReachesATenthOfTheModel) {
    const Reach pair(collada(triangle("mesh", "0 0 0  0 3 0  0 3 4") + animations(still("a/t.X")) +
                             scene("<node id='a'>" + kMove + "</node><node>" + kDrawn + "</node>")));
    EXPECT_NEAR(pair.hanging(0), 0.5, 1e-6);
}

// A unit of the child's parent is two units of the model; the child's own is six.
TEST(MotionReachTest, lengthsAreInTheUnitsOfTheJoint) {
    const Reach scaled(collada(triangle("mesh", "0 0 0  0 3 0  0 3 4") + animations(still("b/t.X")) +
                               scene("<node id='a'><scale>2 2 2</scale><node id='b'>" + kMove +
                                     "<scale>3 3 3</scale>" + kDrawn + "</node></node>")));
    EXPECT_NEAR(scaled.tolerance(1).unit, 2.0, 1e-6);
    EXPECT_NEAR(scaled.tolerance(1).reach, 5.0, 1e-6);
}

TEST(MotionReachTest, jointsThatMoveOnOneWayToAVertexShareTheTolerance) {
    const std::string a = "<node id='a'>" + kMove, b = "<node id='b'>" + kMove, c = "<node id='c'>" + kMove;
    const std::string nodes = a + b + kDrawn + "</node>" + c + "</node></node>";
    const Reach one(collada(triangle() + animations(still("a/t.X")) + scene(nodes)));
    const Reach all(
        collada(triangle() + animations(still("a/t.X") + still("b/t.X") + still("c/t.X")) + scene(nodes)));
    EXPECT_NEAR(one.tolerance(0).budget, 0.01 * one.reach.modelSize(), 1e-12);
    for (int joint = 0; joint < 3; ++joint)
        EXPECT_NEAR(all.tolerance(joint).budget, one.tolerance(0).budget / std::sqrt(2.0), 1e-12) << joint;
}

TEST(MotionReachTest, aToleranceBelowWhatFloatsTellIsTakenAsThat) {
    const Reach box(boxOf("0 0 0 1 0 0 0 1 0"));
    const double finest = MotionReach::finestShare();
    EXPECT_EQ(box.reach.tolerance(0, 1e-9).budget, box.reach.tolerance(0, finest).budget);
    EXPECT_LT(box.reach.tolerance(0, finest).budget, box.reach.tolerance(0, 1e-7).budget);
}

TEST(MotionReachTest, theNumbersOfALightMayBeOffByAShareOfWhatTheyAre) {
    const Reach box(boxOf("0 0 0 1 0 0 0 1 0"));
    Parameter parameter;
    parameter.kind = ParameterKind::LightValue;
    parameter.restValue = 0.25f;
    EXPECT_DOUBLE_EQ(box.reach.tolerance(parameter, box.model, 0.01).budget, 0.01);
    parameter.restValue = -500.0f;
    EXPECT_DOUBLE_EQ(box.reach.tolerance(parameter, box.model, 0.01).budget, 5.0);
}

// Keys that put the box elsewhere: its farthest corner counts, whichever of the eight that is.
TEST(MotionReachTest, theErrorIsThatOfTheFarthestCorner) {
    for (const char* positions :
         {"-1 -2 -3  1 2 3  0 0 0", "4 -2 -3  6 2 3  5 0 0", "-6 5 7  -4 9 13  -5 7 10"}) {
        const Reach box(boxOf(positions));
        const std::vector<glm::vec3>& corners = box.model.meshes.at(0).positions;
        for (int signs = 0; signs < 8; ++signs) {
            const glm::vec3 along(0.5f, signs & 1 ? 0.25f : -0.25f, signs & 2 ? 0.125f : -0.125f);
            const glm::vec3 shift(signs & 4 ? 0.75f : 0.0f, 0.0f, 0.0f);
            glm::mat4 off(1.0f);
            for (int column = 0; column < 3; ++column) off[column].x += along[column];
            off[3] += glm::vec4(shift, 0.0f);
            Animation keys;
            keys.endSeconds = 1.0;
            keys.channels.resize(1);
            keys.channels[0].matrixKeyFrames = {{0.0, off, false}};
            float farthest = 0.0f;
            for (int corner = 0; corner < 8; ++corner) {
                glm::vec3 point;
                for (int axis = 0; axis < 3; ++axis) point[axis] = corners[(corner >> axis) & 1][axis];
                farthest = std::max(farthest, std::abs(glm::dot(along, point) + shift.x));
            }
            EXPECT_NEAR(box.reach.measure(box.model, box.motion, keys), farthest / box.reach.modelSize(),
                        1e-6)
                << positions << " " << signs;
        }
    }
}

TEST(MotionReachTest, errorsOfAChainAreMeasuredWhereTheyAddUp) {
    const Reach arm(
        collada(triangle("mesh", "0 0 0  0 3 0  0 3 4") + animations(still("a/t.X") + still("b/t.X")) +
                scene("<node id='a'>" + kMove + "<node id='b'>" + kMove + kDrawn + "</node></node>")));
    Animation keys;
    keys.endSeconds = 1.0;
    for (int joint = 0; joint < 2; ++joint) {
        Channel& channel = keys.channels.emplace_back();
        channel.joint = joint;
        channel.keyFrames = {{0.0, {.position = {0.1f, 0.0f, 0.0f}}, false}};
    }
    EXPECT_NEAR(arm.reach.measure(arm.model, arm.motion, keys), 0.2 / 5.0, 1e-6);
}

TEST(MotionReachTest, aSkinsPointsHangOnTheJointsThatPullThem) {
    SkinText skin;
    skin.inverseBinds = matrixSource("binds", kIdentity + kIdentity);
    skin.vcount = "1 1 2";
    skin.v = "0 0  1 0  0 1 1 1";
    const std::string text = collada(triangle() + controllers(skin.text()) + animations(still("knee/t.X")) +
                                     scene("<node id='hip' sid='hip'><translate>0 0 6</translate></node>"
                                           "<node id='knee' sid='knee'>" +
                                           kMove + "</node><node><instance_controller url='#skin'/></node>"));
    const Reach reach(text);
    // Posed, the first point is 6 up, and the third, pulled by both joints, 3 up.
    EXPECT_NEAR(reach.reach.modelSize(), std::sqrt(1.0 + 1.0 + 36.0), 1e-5);
    EXPECT_NEAR(reach.hanging(1), std::sqrt(2.0), 1e-5);  // of the box around (1 0 0) and (0 1 0)
}

}  // namespace
}  // namespace walkcycle
