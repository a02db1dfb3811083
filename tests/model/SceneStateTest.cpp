#include <vector>

#include <gtest/gtest.h>

#include "walkcycle/model/SceneState.h"

namespace walkcycle {
namespace {

Model modelWith(ParameterKind kind, int component) {
    Model model;
    model.skeleton.joints.resize(1);
    model.cameras.resize(1);
    model.lights.resize(1);
    model.materials.resize(1);
    model.parameters = {{kind, 0, component, 0.0f}};
    return model;
}

SceneState stateWith(ParameterKind kind, int component, float value) {
    const Model model = modelWith(kind, component);
    SceneState state(model);
    state.apply(model, std::vector<float>{value});
    return state;
}

TEST(SceneStateTest, startsAsTheModelIs) {
    Model model = modelWith(ParameterKind::MorphWeight, 0);
    model.lights[0].intensity = 3.0f;
    model.cameras[0].yfov = 40.0;

    const SceneState state(model);

    EXPECT_FLOAT_EQ(state.lights[0].intensity, 3.0f);
    EXPECT_EQ(state.cameras[0].yfov, 40.0);
    EXPECT_TRUE(state.nodeVisible[0]);
}

TEST(SceneStateTest, parametersMoveCamerasAndLights) {
    const auto camera = [](CameraComponent component) {
        return stateWith(ParameterKind::CameraValue, static_cast<int>(component), 2.0f).cameras[0];
    };
    EXPECT_EQ(camera(CameraComponent::XFov).xfov, 2.0);
    EXPECT_EQ(camera(CameraComponent::YMag).ymag, 2.0);
    EXPECT_EQ(camera(CameraComponent::Aspect).aspect, 2.0);
    EXPECT_EQ(camera(CameraComponent::ZFar).zfar, 2.0);

    const auto light = [](LightComponent component) {
        return stateWith(ParameterKind::LightValue, static_cast<int>(component), 2.0f).lights[0];
    };
    EXPECT_FLOAT_EQ(light(LightComponent::Intensity).intensity, 2.0f);
    EXPECT_FLOAT_EQ(light(LightComponent::QuadraticAttenuation).quadraticAttenuation, 2.0f);
    EXPECT_FLOAT_EQ(light(LightComponent::FalloffAngle).falloffAngle, 2.0f);
    EXPECT_EQ(stateWith(ParameterKind::LightColor, 1, 0.5f).lights[0].color, glm::vec3(1.0f, 0.5f, 1.0f));
}

TEST(SceneStateTest, parametersMoveTheRightChannelOfTheRightSlot) {
    const int red = static_cast<int>(Slot::Diffuse) * 4;
    const Material material = stateWith(ParameterKind::MaterialColor, red, 0.75f).materials[0];

    EXPECT_FLOAT_EQ(material.slot(Slot::Diffuse).color.r, 0.75f);
    EXPECT_FLOAT_EQ(material.slot(Slot::Diffuse).color.g, 0.0f);
    EXPECT_FLOAT_EQ(material.slot(Slot::Ambient).color.r, 0.0f);
    EXPECT_FALSE(material.transparent);
}

TEST(SceneStateTest, aMaterialThatFadesIsDrawnWithBlending) {
    const auto transparency = static_cast<int>(MaterialComponent::Transparency);

    EXPECT_FALSE(stateWith(ParameterKind::MaterialValue, transparency, 1.0f).materials[0].transparent);
    EXPECT_TRUE(stateWith(ParameterKind::MaterialValue, transparency, 0.4f).materials[0].transparent);
}

TEST(SceneStateTest, nodesAppearAndVanish) {
    EXPECT_FALSE(stateWith(ParameterKind::NodeVisible, 0, 0.0f).nodeVisible[0]);
    EXPECT_TRUE(stateWith(ParameterKind::NodeVisible, 0, 1.0f).nodeVisible[0]);
}

TEST(SceneStateTest, theModelsRestParametersComeInOrder) {
    Model model;
    model.parameters = {{ParameterKind::MorphWeight, 0, 0, 0.25f}, {ParameterKind::MorphWeight, 0, 1, 0.5f}};

    EXPECT_EQ(model.restParameters(), (std::vector<float>{0.25f, 0.5f}));
}

}  // namespace
}  // namespace walkcycle
