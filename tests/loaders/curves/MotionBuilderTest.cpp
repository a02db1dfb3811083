#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/curves/MotionBuilder.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kMatrix = "<matrix sid='m'>" + kIdentity + "</matrix>";
const std::string kStack = "<translate sid='t'>0 0 0</translate><scale sid='s'>1 1 1</scale>" + kMatrix;

// What is said of the only channel, which is on a line of its own.
Diagnostic saidOf(const AnimationText& animation, const std::string& stack = kStack) {
    const std::string text =
        boxWith(stack, animations("<animation id='a'>" + animation.sources() + animation.sampler() + "\n" +
                                  animation.channel() + "</animation>"));
    const Model model = loadText(text);
    EXPECT_THAT(model.animations, IsEmpty()) << animation.target;
    for (const Diagnostic& said : model.diagnostics)
        if (said.line == lineOf(text, "<channel")) return said;
    ADD_FAILURE() << "nothing is said of " << animation.target;
    return {};
}

TEST(MotionBuilderTest, aPartThatTheElementDoesNotHaveIsReported) {
    for (const char* target :
         {"box/t(0)(1)", "box/m(4)(0)", "box/m(0)(4)", "box/m(16)", "box/t(3)", "box/t.W"}) {
        const Diagnostic said = saidOf({target, "0 2", "0 4"});
        EXPECT_EQ(said.code, "WC0509") << target;
        EXPECT_THAT(said.message, HasSubstr(target));
    }
}

TEST(MotionBuilderTest, aMatrixIsWhollyMeantByAnyMemberItDoesNotHave) {
    AnimationText matrix{"box/m.TRANSFORM", "0 2", kIdentity + "1 0 0 2 0 1 0 4 0 0 1 6 0 0 0 1"};
    matrix.params = "M";
    const Model model = loadText(boxWith(kMatrix, animations(matrix.text())));
    EXPECT_THAT(codes(model.diagnostics), IsEmpty());
    EXPECT_NEAR(exactLocal(model, 1.0)[3].y, 2.0, 1e-9);
}

TEST(MotionBuilderTest, whatANodeHoldsBesideItsTransformsDoesNotMove) {
    const Diagnostic shape =
        saidOf({"box/shape", "0 2", "0 4"}, "<instance_geometry sid='shape' url='#mesh'/>");
    EXPECT_EQ(shape.code, "WC0508");
    EXPECT_THAT(shape.message, HasSubstr("instance_geometry"));
    const Diagnostic node = saidOf({"box/hand", "0 2", "0 4"}, "<node sid='hand'/>");
    EXPECT_EQ(node.code, "WC0508");
}

TEST(MotionBuilderTest, aNodeThatNoSceneShowsDoesNotMove) {
    const Model model = loadText(boxWith(
        "", "<library_nodes><node id='spare'><translate sid='t'>0 0 0</translate></node></library_nodes>" +
                animations(AnimationText{"spare/t.X", "0 2", "0 4"}.text())));
    EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0508"));
    EXPECT_THAT(model.animations, IsEmpty());
}

TEST(MotionBuilderTest, moreNumbersThanAnythingTakesAreReported) {
    AnimationText wide{"box/m", "0 1", kIdentity + "1 " + kIdentity + "1"};
    wide.params = "ABCDEFGHIJKLMNOPQ";
    EXPECT_EQ(saidOf(wide).code, "WC0510");
}

// Libraries that somebody put together from others keep the unit and the axes of each.
TEST(MotionBuilderTest, anAssetOnTheAnimationsTurnsAndScalesWhatTheyMove) {
    const std::string centimetres = "<asset><unit meter='0.01'/><up_axis>Z_UP</up_axis></asset>";
    const AnimationText up{"box/t.Z", "0 2", "0 400"};
    const AnimationText all{
        .target = "box/t", .times = "0 2", .values = "0 0 0 100 200 400", .params = "XYZ"};
    for (const auto& [animation, expected] :
         {std::pair(up, glm::vec3(9, 2, 9)), std::pair(all, glm::vec3(0.5, 2, -1))}) {
        const Model model = loadText(
            boxWith("<translate sid='t'>9 9 9</translate>", animations(centimetres + animation.text())));
        EXPECT_THAT(codes(model.diagnostics), IsEmpty());
        EXPECT_NEAR(glm::distance(glm::vec3(keyed(model, 1.0)[3]), expected), 0.0f, 1e-3f);
    }
    const Model rotated =
        loadText(boxWith("<rotate sid='r'>0 0 1 0</rotate>",
                         animations(centimetres + AnimationText{"box/r.ANGLE", "0 2", "0 180"}.text())));
    EXPECT_NEAR(keyed(rotated, 1.0)[0].y, 1.0f, 1e-3f);
}

std::string lampMoved(const std::string& body) {
    return collada(
        "<library_lights><light id='lamp'><technique_common><spot><color sid='c'>1 0.5 0</color>"
        "<falloff_angle sid='f'>90</falloff_angle></spot></technique_common></light></library_lights>" +
        animations(body) + scene("<node id='n'><instance_light url='#lamp'/></node>"));
}

double parameterAt(const Model& model, double seconds) {
    std::vector<glm::dmat4> locals(model.skeleton.joints.size());
    std::vector<double> parameters(model.parameters.size());
    model.exactMotion->evaluate(seconds, locals, parameters);
    return parameters.back();
}

TEST(MotionBuilderTest, aSingleNumberMayBeCalledByAnyMember) {
    const Model model = loadText(lampMoved(AnimationText{"lamp/f.ANGLE", "0 2", "90 30"}.text()));
    EXPECT_THAT(codes(model.diagnostics), IsEmpty());
    EXPECT_NEAR(parameterAt(model, 1.0), 60.0, 1e-9);
    const Model odd = loadText(lampMoved(AnimationText{"lamp/f.WIDTH", "0 2", "90 30"}.text()));
    EXPECT_NEAR(parameterAt(odd, 1.0), 60.0, 1e-9);
}

TEST(MotionBuilderTest, aPartThatAColourDoesNotHaveIsReported) {
    for (const char* target : {"lamp/c.ALPHA", "lamp/c(3)", "lamp/c(0)(1)"}) {
        const Model model = loadText(lampMoved(AnimationText{target, "0 2", "0 1"}.text()));
        EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0509")) << target;
        EXPECT_THAT(model.diagnostics[0].message, HasSubstr("color"));
    }
}

TEST(MotionBuilderTest, ofTwoChannelsOnOneNumberTheOneThatBeginsLaterTakesOver) {
    const AnimationText first{.target = "lamp/f", .times = "0 1", .values = "90 80", .id = "a"};
    const AnimationText second{.target = "lamp/f", .times = "2 3", .values = "50 30", .id = "b"};
    const Model model = loadText(lampMoved(first.text() + second.text()));
    EXPECT_NEAR(parameterAt(model, 1.5), 80.0, 1e-9);
    EXPECT_NEAR(parameterAt(model, 2.5), 40.0, 1e-9);
    ASSERT_THAT(model.animations, SizeIs(1));
    EXPECT_THAT(model.animations[0].parameterTracks, SizeIs(1));
}

}  // namespace
}  // namespace walkcycle
