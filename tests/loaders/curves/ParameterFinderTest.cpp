#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/curves/ParameterFinder.h"
#include "walkcycle/model/SceneState.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// What the animated parameters are at a time, by the keyframes and by the file's curves alike.
std::vector<float> parametersAt(const Model& model, double seconds) {
    Animator animator(model.skeleton, model.restParameters());
    animator.doAnimation(model.animations.at(0));
    animator.sampleAt(seconds);
    const std::vector<float>& keyedValues = animator.parameters();
    std::vector<glm::dmat4> locals(model.skeleton.joints.size());
    std::vector<double> exact(model.parameters.size());
    model.exactMotion->evaluate(seconds, locals, exact);
    for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_NEAR(keyedValues[i], exact[i], 1e-3);
    return keyedValues;
}

std::string moved(const std::string& target, const std::string& values, const std::string& params = "X") {
    AnimationText animation{target, "0 2", values};
    animation.params = params;
    return animations(animation.text());
}

const std::string kMorph =
    triangle("tall", "0 0 0 2 0 0 0 2 0") + triangle("wide", "0 0 0 5 0 0 0 1 0") +
    controllers("<controller id='morph'><morph source='#mesh' method='RELATIVE'>" +
                nameSource("targets", "tall wide", "IDREF_array") +
                floatSource("morph-weights", "0.1 0.2", "W") +
                "<targets><input semantic='MORPH_TARGET' source='#targets'/>"
                "<input semantic='MORPH_WEIGHT' source='#morph-weights'/></targets></morph></controller>");

Model morphMoved(const std::string& animation) {
    return loadText(collada(triangle() + kMorph + animation +
                            scene("<node id='box'><instance_controller url='#morph'/></node>")));
}

TEST(ParameterFinderTest, morphWeightsAreNamedByArraySourceOrController) {
    for (const char* target : {"morph-weights(1)", "morph-weights-array(1)", "morph/morph-weights(1)",
                               "morph/weights(1)", "morph(1)"}) {
        const Model model = morphMoved(moved(target, "0 1"));
        const bool isQuirk = std::string_view(target).find('/') != std::string_view::npos;
        EXPECT_THAT(codes(model.diagnostics), SizeIs(isQuirk ? 1 : 0)) << target;
        ASSERT_THAT(model.animations, SizeIs(1)) << target;
        EXPECT_THAT(parametersAt(model, 1.0), ElementsAre(0.1f, testing::FloatNear(0.5f, 1e-3f))) << target;
    }
}

TEST(ParameterFinderTest, allMorphWeightsMoveTogetherWhereNoneIsNamed) {
    const Model model = morphMoved(moved("morph-weights", "0 0 1 0.5", "XY"));
    EXPECT_THAT(parametersAt(model, 1.0),
                ElementsAre(testing::FloatNear(0.5f, 1e-3f), testing::FloatNear(0.25f, 1e-3f)));
}

TEST(ParameterFinderTest, smoothWeightsTakeFewKeys) {
    AnimationText swell{"morph-weights(0)", "0 1 2", "0 1 0"};
    swell.interpolations = "CARDINAL";
    const Model model = morphMoved(animations(swell.text()));
    EXPECT_LT(model.animations.at(0).parameterTracks.at(0).keyFrames.size(), 10u);
    for (const double seconds : {0.2, 0.7, 1.3, 1.99}) parametersAt(model, seconds);
}

TEST(ParameterFinderTest, cameraAndLightValuesMove) {
    const std::string libraries =
        "<library_cameras><camera id='cam'><optics><technique_common><perspective><xfov sid='fov'>40</xfov>"
        "<znear>0.1</znear><zfar>10</zfar></perspective></technique_common></optics></camera></"
        "library_cameras>"
        "<library_lights><light id='lamp'><technique_common><point><color sid='c'>1 0.5 0</color>"
        "<quadratic_attenuation "
        "sid='q'>1</quadratic_attenuation></point></technique_common></light></library_lights>" +
        animations(AnimationText{.target = "cam/fov", .times = "0 2", .values = "40 60", .id = "a"}.text() +
                   AnimationText{.target = "lamp/c.G", .times = "0 2", .values = "0.5 1", .id = "b"}.text() +
                   AnimationText{.target = "lamp/q", .times = "0 2", .values = "1 3", .id = "d"}.text());
    const Model model = loadText(collada(
        libraries + scene("<node id='n'><instance_camera url='#cam'/><instance_light url='#lamp'/></node>")));
    EXPECT_THAT(codes(model.diagnostics), IsEmpty());
    SceneState state(model);
    state.apply(model, parametersAt(model, 1.0));
    EXPECT_NEAR(state.cameras.at(0).xfov.value_or(0.0), 50.0, 0.01);
    EXPECT_NEAR(state.lights.at(0).color.g, 0.75f, 1e-3f);
    EXPECT_NEAR(state.lights.at(0).color.r, 1.0f, 1e-6f);
    EXPECT_NEAR(state.lights.at(0).quadraticAttenuation, 2.0f, 1e-2f);
}

// A box with material "red"; `profile` stands in the effect's profile_COMMON before its technique.
std::string boxOfColour(const std::string& profile, const std::string& diffuse,
                        const std::string& animation) {
    std::string geometry = triangle();
    geometry.replace(geometry.find("<triangles"), 10, "<triangles material='m'");
    return collada(
        geometry + animation + "<library_effects><effect id='fx'><profile_COMMON>" + profile +
        "<technique sid='common'><phong><diffuse>" + diffuse +
        "</diffuse><shininess><float sid='shine'>10</float></shininess></phong></technique></profile_COMMON>"
        "</effect></library_effects><library_materials><material id='red'><instance_effect url='#fx'/>"
        "</material></library_materials>" +
        scene("<node id='box'><instance_geometry url='#mesh'><bind_material><technique_common>"
              "<instance_material symbol='m' target='#red'/></technique_common></bind_material>"
              "</instance_geometry></node>"));
}

Material materialAt(const Model& model, double seconds) {
    SceneState state(model);
    state.apply(model, parametersAt(model, seconds));
    return state.materials.at(0);
}

TEST(ParameterFinderTest, coloursAndNumbersOfMaterialsMove) {
    const Model colour = loadText(boxOfColour("", "<color sid='d'>1 0 0 1</color>", moved("fx/d.G", "0 1")));
    EXPECT_THAT(codes(colour.diagnostics), IsEmpty());
    EXPECT_NEAR(materialAt(colour, 1.0).slot(Slot::Diffuse).color.g, 0.5f, 1e-3f);
    const Model shine = loadText(boxOfColour("", "<color>1 0 0 1</color>", moved("fx/shine", "10 30")));
    EXPECT_NEAR(materialAt(shine, 1.0).shininess, 20.0f, 1e-2f);
}

TEST(ParameterFinderTest, aNewparamMovesTheSlotsThatReferToIt) {
    const Model model =
        loadText(boxOfColour("<newparam sid='tint'><float4>1 0 0 1</float4></newparam>",
                             "<param ref='tint'/>", moved("fx/tint", "1 0 0 1 0 0 1 1", "RGBA")));
    EXPECT_NEAR(materialAt(model, 1.0).slot(Slot::Diffuse).color.b, 0.5f, 1e-3f);
}

TEST(ParameterFinderTest, whatIsNotShownIsANoteOnly) {
    const Model model =
        loadText(boxWith("",
                         "<library_cameras><camera id='cam'><optics><technique_common><perspective>"
                         "<xfov sid='fov'>40</xfov><znear>1</znear><zfar>2</zfar></perspective>"
                         "</technique_common></optics></camera></library_cameras>" +
                             moved("cam/fov", "40 60")));
    EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0508"));
    EXPECT_THAT(model.animations, IsEmpty());
}

TEST(ParameterFinderTest, visibilityBlinks) {
    AnimationText blink{"box/visibility", "0 1 2", "1 0 1"};
    blink.interpolations = "STEP";
    const Model model =
        loadText(boxWith("<extra><technique profile='FCOLLADA'><visibility sid='visibility'>1</visibility>"
                         "</technique></extra>",
                         animations(blink.text())));
    ASSERT_THAT(model.animations, SizeIs(1));
    EXPECT_THAT(parametersAt(model, 0.9), ElementsAre(1.0f));
    EXPECT_THAT(parametersAt(model, 1.1), ElementsAre(0.0f));
}

TEST(ParameterFinderTest, whatIsHiddenAtFirstMayAppear) {
    AnimationText appear{"box/visibility", "1 2", "0 1"};
    appear.interpolations = "STEP";
    const Model model =
        loadText(boxWith("<extra><technique profile='FCOLLADA'><visibility sid='visibility'>0</visibility>"
                         "</technique></extra>",
                         animations(appear.text())));
    EXPECT_THAT(model.restParameters(), ElementsAre(0.0f));
    EXPECT_THAT(parametersAt(model, 2.0), ElementsAre(1.0f));
}

const std::string kCameraAndLamp =
    "<library_cameras><camera id='cam' name='c'><optics sid='o'><technique_common><perspective><xfov "
    "sid='fov'>40</xfov><znear>0.1</znear><zfar>10</zfar></perspective></technique_common></optics></camera>"
    "</library_cameras><library_lights><light id='lamp'><technique_common sid='t'><point><color sid='c'>1 "
    "0.5 0"
    "</color></point></technique_common></light></library_lights>";

TEST(ParameterFinderTest, elementsThatHoldNoValueAreANote) {
    for (const char* target : {"cam/o", "lamp/t", "box/name"}) {
        const Model model = loadText(collada(
            triangle() + kCameraAndLamp + moved(target, "0 1") +
            scene("<node id='box'><extra><technique profile='p'><name sid='name'/></technique></extra>"
                  "<instance_camera url='#cam'/><instance_light url='#lamp'/></node>")));
        EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0508")) << target;
        EXPECT_THAT(model.animations, IsEmpty());
    }
    const Model unused = loadText(boxWith("", kCameraAndLamp + moved("lamp/c.R", "0 1")));
    EXPECT_THAT(codes(unused.diagnostics), ElementsAre("WC0508")) << "no scene shows the lamp";
}

TEST(ParameterFinderTest, channelsOfOneNumberShareItsParameter) {
    const AnimationText a{.target = "lamp/c.R", .times = "0 1", .values = "0 1", .id = "a"};
    const AnimationText b{
        .target = "lamp/c", .times = "2 3", .values = "0 0 0 1 1 1", .params = "RGB", .id = "b"};
    const Model model = loadText(collada(kCameraAndLamp + animations(a.text() + b.text()) +
                                         scene("<node><instance_light url='#lamp'/></node>")));
    EXPECT_THAT(model.parameters, SizeIs(3));
    EXPECT_THAT(model.animations.at(0).parameterTracks, SizeIs(3));
}

TEST(ParameterFinderTest, aParameterMovesEverySlotOfTheMaterialThatRefersToIt) {
    const std::string profile =
        "<newparam sid='tint'><float4>1 0 0 1</float4></newparam>"
        "<newparam sid='other'><float4>1 0 0 1</float4></newparam>";
    std::string text =
        boxOfColour(profile, "<param ref='tint'/>", moved("red/tint", "1 0 0 1 0 0 1 1", "RGBA"));
    const std::string instance = "<instance_effect url='#fx'/>";
    text.replace(
        text.find(instance), instance.size(),
        "<instance_effect url='#fx'><setparam ref='tint' sid='tint'><float4 sid='tint'>1 0 0 1</float4>"
        "</setparam></instance_effect>");
    text.insert(text.find("<shininess>"), "<emission><param ref='other'/></emission>");
    const Model model = loadText(text);
    ASSERT_THAT(model.animations, SizeIs(1));
    EXPECT_NEAR(materialAt(model, 1.0).slot(Slot::Diffuse).color.b, 0.5f, 1e-3f);
    EXPECT_EQ(materialAt(model, 1.0).slot(Slot::Emission).color.b, 0.0f);
}

TEST(ParameterFinderTest, aWholeSlotIsItsColour) {
    std::string text = boxOfColour("", "<color>1 0 0 1</color>", moved("fx/d", "1 0 0 1 0 0 1 1", "RGBA"));
    text.replace(text.find("<diffuse>"), 9, "<diffuse sid='d'>");
    EXPECT_NEAR(materialAt(loadText(text), 1.0).slot(Slot::Diffuse).color.b, 0.5f, 1e-3f);
    const Model odd = loadText(boxOfColour("", "<color>1 0 0 1</color>", moved("fx/common", "0 1")));
    EXPECT_THAT(codes(odd.diagnostics), ElementsAre("WC0508")) << "a technique has no number";
}

}  // namespace
}  // namespace walkcycle
