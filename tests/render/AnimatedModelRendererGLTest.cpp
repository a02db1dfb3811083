#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "render/GlTest.h"
#include "render/ModelResource.h"
#include "render/Srgb.h"
#include "render/TestModels.h"
#include "walkcycle/render/AnimatedModelRenderer.h"
#include "walkcycle/render/Framebuffer.h"

namespace walkcycle {
namespace {

using namespace testing_models;

constexpr RenderOptions kFile{.lights = Lighting::File, .background = Background::Transparent};

class AnimatedModelRendererGLTest : public GlTest {
protected:
    Image draw(const AnimatedModel& model, const RenderOptions& options, const Camera& camera) {
        Framebuffer picture(64, 64);
        renderer_.render(model, camera, picture, options);
        return picture.read();
    }
    Image draw(const AnimatedModel& model, const RenderOptions& options) {
        return draw(model, options, Camera::framing(model.bounds(), 1.0f, CameraPreset::Front));
    }
    Image draw(const Model& model, const RenderOptions& options) {
        return draw(AnimatedModel(model), options);
    }

    AnimatedModelRenderer renderer_;
};

TEST_F(AnimatedModelRendererGLTest, givesTheSameBytesTwice) {
    const AnimatedModel model(skinned(9, 7));
    EXPECT_EQ(draw(model, {}).rgba, draw(model, {}).rgba);
}

TEST_F(AnimatedModelRendererGLTest, drawsABallInTheMiddleOnAGradient) {
    Framebuffer picture(320, 240);
    const AnimatedModel model(rigid(ball(32, 48), glm::translate(glm::mat4(1.0f), {0, 1, 0})));
    renderer_.render(model, Camera::framing(model.bounds(), picture.aspect()), picture, {});
    const Image image = picture.read();
    keep(image, "studio-ball");
    EXPECT_NE(pixel(image, 160, 120), pixel(image, 5, 120));
    EXPECT_EQ(pixel(image, 5, 120)[3], 255);
}

// Read twice: as the renderer left the picture, and after somebody asked for its target, who may have drawn anywhere.
void expectAllIsRead(const Framebuffer& picture) {
    const Image image = picture.read();
    (void)picture.target();
    EXPECT_EQ(image.rgba, picture.read().rgba);
}

TEST_F(AnimatedModelRendererGLTest, readingLeavesNothingOut) {
    Model morphed = rigid(ball());
    addMorph(morphed, MorphMethod::Normalized, {3.0f});
    Framebuffer picture(96, 64);
    for (const Model& shown : {rigid(ball()), skinned(9, 7), skinned(3, 2), morphed}) {
        const AnimatedModel model(shown);
        const Camera framed = Camera::framing(model.bounds(), picture.aspect());
        Camera aside = framed, inside = framed;
        aside.view = glm::translate(glm::mat4(1.0f), {1.2f, 0.9f, 0.0f}) * framed.view;
        inside.view = glm::lookAt(glm::vec3(0.1f), glm::vec3(1.0f), {0, 1, 0});
        for (const Camera& camera : {framed, aside, inside})
            for (const RenderOptions& options :
                 {RenderOptions{}, kFile, RenderOptions{.wireframe = true, .skeleton = true}}) {
                renderer_.render(model, camera, picture, options);
                expectAllIsRead(picture);
            }
    }
}

TEST_F(AnimatedModelRendererGLTest, whatIsDrawnBesideTheModelIsRead) {
    const AnimatedModel model(rigid(ball()));
    Framebuffer picture(200, 100);
    const RenderTarget target = picture;
    Camera camera = Camera::framing(model.bounds(), picture.aspect(), CameraPreset::Front);
    renderer_.render(model, camera, target, kFile);
    EXPECT_EQ(pixel(picture.read(), 10, 50)[3], 0);
    camera.projection = glm::translate(glm::mat4(1.0f), {-0.9f, 0.0f, 0.0f}) * camera.projection;
    renderer_.draw(model, camera, target, kFile);
    EXPECT_EQ(pixel(picture.read(), 10, 50)[3], 255);

    renderer_.render(model, camera, target, kFile);
    glBindFramebuffer(GL_FRAMEBUFFER, picture.target().framebuffer);
    glEnable(GL_SCISSOR_TEST);
    glScissor(190, 0, 10, 10);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(pixel(picture.read(), 195, 95)[3], 255);
    EXPECT_EQ(pixel(picture.read(), 195, 50)[3], 0);
}

TEST_F(AnimatedModelRendererGLTest, withoutABackgroundSolidThingsHaveFullAlphaAndTheRestIsClearBlack) {
    const Image image = draw(rigid(square()), kFile);
    EXPECT_EQ(pixel(image, 32, 32)[3], 255);
    EXPECT_EQ(pixel(image, 0, 0), (std::array{0, 0, 0, 0}));
}

TEST_F(AnimatedModelRendererGLTest, fileColoursArriveAsTheyAreInTheFile) {
    const Image image = draw(rigid(square(), glm::mat4(1.0f), glowing({0.2f, 0.498f, 0.8f, 1.0f})), kFile);
    EXPECT_EQ(pixel(image, 32, 32), (std::array{51, 127, 204, 255}));
}

TEST_F(AnimatedModelRendererGLTest, lambertUnderAHeadlightShowsItsDiffuseColour) {
    const Image image = draw(rigid(square(), glm::mat4(1.0f), colored({0.2f, 0.5f, 0.8f, 1.0f})), kFile);
    const auto middle = pixel(image, 32, 32);
    EXPECT_NEAR(middle[0], 51, 1);
    EXPECT_NEAR(middle[1], 128, 1);
    EXPECT_NEAR(middle[2], 204, 1);
}

TEST_F(AnimatedModelRendererGLTest, halfOpaqueThingsHaveHalfTheAlphaAndTheirOwnColour) {
    Material glass = glowing({0.8f, 0.4f, 0.2f, 1.0f});
    glass.transparent = true;
    glass.slot(Slot::Transparent) = {
        .present = true, .color = glm::vec4(1.0f), .texture = -1, .texCoordName = {}};
    glass.transparency = 0.5f;
    const auto middle = pixel(draw(rigid(square(), glm::mat4(1.0f), glass), kFile), 32, 32);
    EXPECT_NEAR(middle[3], 128, 1);
    EXPECT_NEAR(middle[0], 204, 2);
    EXPECT_NEAR(middle[1], 102, 2);
    EXPECT_NEAR(middle[2], 51, 2);
}

TEST_F(AnimatedModelRendererGLTest, bothSidesOfASquareAreLit) {
    const glm::mat4 rotated = glm::rotate(glm::mat4(1.0f), 3.14159265f, {0, 1, 0});
    const auto front = pixel(draw(rigid(square()), kFile), 32, 32);
    const auto back = pixel(draw(rigid(square(), rotated), kFile), 32, 32);
    EXPECT_EQ(front, back);
}

TEST_F(AnimatedModelRendererGLTest, mirroringChangesNothingOfHowABallIsLit) {
    const Image plain = draw(rigid(ball()), kFile);
    const Image mirrored = draw(rigid(ball(), glm::scale(glm::mat4(1.0f), {-1.0f, 1.0f, 1.0f})), kFile);
    for (int x = 16; x < 48; ++x) EXPECT_NEAR(pixel(plain, x, 30)[0], pixel(mirrored, x, 30)[0], 2) << x;
}

// Two texels, black and white, that cover less than a pixel each: as light their mean is 188, not 128.
TEST_F(AnimatedModelRendererGLTest, texturesAreAveragedAsLight) {
    Image checks{.width = 256, .height = 256, .hasAlpha = false, .rgba = {}};
    for (int i = 0; i < 256 * 256; ++i) {
        const std::uint8_t value = (i + i / 256) % 2 ? 255 : 0;
        checks.rgba.insert(checks.rgba.end(), {value, value, value, 255});
    }
    Model model = rigid(square(), glm::mat4(1.0f), glowing(glm::vec4(1.0f)));
    Texture texture;
    texture.image = std::make_shared<const Image>(checks);
    model.textures.push_back(texture);
    model.materials[0].slot(Slot::Emission).texture = 0;
    for (const Lighting lighting : {Lighting::File, Lighting::Studio}) {
        RenderOptions options = kFile;
        options.lights = lighting;
        EXPECT_NEAR(pixel(draw(model, options), 32, 32)[1], 188, 6);
    }
}

TEST_F(AnimatedModelRendererGLTest, texturesStandUpright) {
    // Top row red and green, bottom row blue and white.
    const Image corners{.width = 2,
                        .height = 2,
                        .hasAlpha = false,
                        .rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
    Model model = rigid(square(), glm::mat4(1.0f), glowing(glm::vec4(1.0f)));
    Texture texture;
    texture.image = std::make_shared<const Image>(corners);
    texture.minFilter = texture.magFilter = Filter::Nearest;
    model.textures.push_back(texture);
    model.materials[0].slot(Slot::Emission).texture = 0;
    const Image image = draw(model, kFile);
    EXPECT_EQ(pixel(image, 16, 16), (std::array{255, 0, 0, 255}));
    EXPECT_EQ(pixel(image, 48, 16), (std::array{0, 255, 0, 255}));
    EXPECT_EQ(pixel(image, 16, 48), (std::array{0, 0, 255, 255}));
}

// A texel of one colour as the picture of a slot.
int addTexture(Model& model, const std::array<std::uint8_t, 4>& texel) {
    Texture texture;
    texture.image = std::make_shared<const Image>(
        Image{.width = 1, .height = 1, .hasAlpha = true, .rgba = {texel.begin(), texel.end()}});
    model.textures.push_back(texture);
    return static_cast<int>(model.textures.size()) - 1;
}

TEST_F(AnimatedModelRendererGLTest, aBumpPictureTurnsTheNormalAlongItsTangents) {
    const auto brightness = [&](const std::array<std::uint8_t, 4>& normal) {
        MeshData mesh = square();
        mesh.tangents.assign(4, {1, 0, 0, 1});
        Model model = rigid(mesh, glm::mat4(1.0f), colored(glm::vec4(1.0f)));
        model.materials[0].slot(Slot::Bump).texture = addTexture(model, normal);
        return pixel(draw(model, kFile), 32, 32)[0];
    };
    EXPECT_NEAR(brightness({128, 128, 255, 255}), 255, 2);  // straight up: as without
    EXPECT_NEAR(brightness({218, 128, 218, 255}), 180, 3);  // 45 degrees: the cosine
    EXPECT_NEAR(brightness({255, 128, 128, 255}), 0, 3);    // on its side
}

TEST_F(AnimatedModelRendererGLTest, eachSlotMayHaveTextureCoordinatesOfItsOwn) {
    // Half red, half green; emission looks at the left half, diffuse at the right one.
    MeshData mesh = square();
    mesh.texCoordSets = {{.set = 0, .coords = std::vector<glm::vec2>(4, {0.25f, 0.5f})},
                         {.set = 1, .coords = std::vector<glm::vec2>(4, {0.75f, 0.5f})}};
    Model model = rigid(mesh, glm::mat4(1.0f), colored(glm::vec4(1.0f)));
    Texture texture;
    texture.minFilter = texture.magFilter = Filter::Nearest;
    texture.image = std::make_shared<const Image>(
        Image{.width = 2, .height = 1, .hasAlpha = false, .rgba = {255, 0, 0, 255, 0, 255, 0, 255}});
    model.textures.push_back(texture);
    model.materials[0].slot(Slot::Emission) = {
        .present = true, .color = glm::vec4(1.0f), .texture = 0, .texCoordName = {}};
    model.materials[0].slot(Slot::Diffuse).texture = 0;
    model.instances[0].materials[0].texCoordSets[static_cast<std::size_t>(Slot::Diffuse)] = 1;
    EXPECT_EQ(pixel(draw(model, kFile), 32, 32), (std::array{255, 255, 0, 255}));
}

TEST_F(AnimatedModelRendererGLTest, aSolidTexelOfASeeThroughPictureHidesWhatIsBehindIt) {
    Model model = rigid(square(), glm::mat4(1.0f), glowing({1, 0, 0, 1}));
    Material& leaf = model.materials[0];
    leaf.transparent = true;
    leaf.slot(Slot::Transparent) = {
        .present = true, .color = glm::vec4(1.0f), .texture = -1, .texCoordName = {}};
    leaf.slot(Slot::Transparent).texture = addTexture(model, {255, 255, 255, 255});
    EXPECT_EQ(pixel(draw(model, kFile), 32, 32), (std::array{255, 0, 0, 255}));
}

TEST_F(AnimatedModelRendererGLTest, whatTheCpuDeformsIsDrawnWhereItIs) {
    // A morph after a skin is beyond the shader.
    Model model = skinned(5, 4);
    addMorph(model, MorphMethod::Relative, {0.0f});
    const Image onGpu = draw(model, kFile);
    std::swap(model.instances[0].deformers[0], model.instances[0].deformers[1]);
    const AnimatedModel onCpu(model);
    ASSERT_TRUE(onCpu.resource()->instances()[0].deformedOnCpu);
    const Image image = draw(onCpu, kFile);
    int different = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x)
            different += std::abs(pixel(image, x, y)[3] - pixel(onGpu, x, y)[3]) > 64;
    }
    EXPECT_LT(different, 10);
}

TEST_F(AnimatedModelRendererGLTest, aNearPaneIsBlendedOverAFarOneWhateverTheirOrder) {
    Model model = rigid(square(), glm::mat4(1.0f), glowing({1, 0, 0, 1}));
    model.materials.push_back(glowing({0, 1, 0, 1}));
    for (Material& material : model.materials) {
        material.transparent = true;
        material.slot(Slot::Transparent) = {
            .present = true, .color = glm::vec4(1.0f), .texture = -1, .texCoordName = {}};
        material.transparency = 0.5f;
    }
    model.skeleton.joints.push_back(node(glm::translate(glm::mat4(1.0f), {0, 0, -1})));
    model.instances.push_back(model.instances[0]);
    model.instances[1].node = 1;
    model.instances[1].materials[0].material = 1;
    const auto nearFirst = pixel(draw(model, kFile), 32, 32);
    std::swap(model.instances[0], model.instances[1]);
    EXPECT_EQ(nearFirst, pixel(draw(model, kFile), 32, 32));
    EXPECT_GT(nearFirst[0], nearFirst[1]);
}

TEST_F(AnimatedModelRendererGLTest, aHiddenNodeHidesWhatHangsOnIt) {
    Model model = rigid(square());
    model.skeleton.joints.push_back(node(glm::mat4(1.0f), 0));
    model.instances[0].node = 1;
    model.nodeVisible = {false, true};
    EXPECT_EQ(pixel(draw(model, kFile), 32, 32)[3], 0);
}

TEST_F(AnimatedModelRendererGLTest, attenuationCountsInTheDocumentsUnits) {
    // A lamp two units (centimetres here) in front of a square: 1 / (2 * distance) = 0.25 of its light arrives.
    Model model = rigid(square(), glm::mat4(1.0f), colored(glm::vec4(1.0f)));
    model.skeleton.rootTransform = glm::scale(glm::mat4(1.0f), glm::vec3(0.01f));
    model.skeleton.joints.push_back(node(glm::translate(glm::mat4(1.0f), {0, 0, 2})));
    SceneLight lamp;
    lamp.kind = LightKind::Point;
    lamp.constantAttenuation = 0.0f;
    lamp.linearAttenuation = 2.0f;
    model.lights.push_back(lamp);
    model.lightInstances.push_back({.node = 1, .light = 0});
    EXPECT_NEAR(pixel(draw(model, kFile), 32, 32)[0], 64, 2);
}

TEST_F(AnimatedModelRendererGLTest, linesAreDrawn) {
    MeshData mesh = square();
    mesh.indices = {0, 2, 1, 3};
    mesh.parts[0].primitive = Primitive::Lines;
    mesh.parts[0].indexCount = 4;
    mesh.normals.assign(4, glm::vec3(0.0f));
    EXPECT_GT(pixel(draw(rigid(mesh), kFile), 32, 32)[3], 100);
}

TEST_F(AnimatedModelRendererGLTest, aBackgroundColourIsTheColourGiven) {
    RenderOptions options;
    options.background = Background::Color;
    options.backgroundColor = {64.0f / 255.0f, 128.0f / 255.0f, 1.0f};
    options.grid = false;
    EXPECT_EQ(pixel(draw(rigid(ball()), options), 1, 1), (std::array{64, 128, 255, 255}));
}

TEST_F(AnimatedModelRendererGLTest, skeletonAndEdgesShowOnTop) {
    const AnimatedModel model(skinned(9, 4));
    RenderOptions options;
    const Image plain = draw(model, options);
    options.skeleton = true;
    EXPECT_NE(plain.rgba, draw(model, options).rgba);
    options.skeleton = false;
    options.wireframe = true;
    EXPECT_NE(plain.rgba, draw(model, options).rgba);
}

}  // namespace
}  // namespace walkcycle
