#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "render/GlTest.h"
#include "render/ModelResource.h"
#include "render/TestModels.h"
#include "walkcycle/render/AnimatedModelRenderer.h"
#include "walkcycle/render/CrowdRenderer.h"
#include "walkcycle/render/Framebuffer.h"
#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {
namespace {

using namespace testing_models;

// A skinned ball, and a square on a node of its own; both rotate for a second. Only the ball if it is of glass.
std::shared_ptr<const Model> dancer(bool seeThrough = false) {
    Model model = skinned(9, 6);
    model.meshes.push_back(square());
    MeshInstance board = model.instances[0];
    board.mesh = 1;
    board.node = 3;
    board.deformers.clear();
    if (!seeThrough) model.instances.push_back(board);
    Animation clip;
    clip.endSeconds = 1.0;
    for (const int joint : {2, 3, 5, 8}) {
        Channel channel{.joint = joint, .keyFrames = {}};
        for (const float t : {0.0f, 0.5f, 1.0f}) {
            JointTransform transform;
            transform.position = {std::sin(3.0f * t), 0.2f * static_cast<float>(joint), 0.0f};
            transform.rotation = glm::angleAxis(t * 2.0f, glm::vec3(0.0f, 0.6f, 0.8f));
            channel.keyFrames.push_back({t, transform});
        }
        clip.channels.push_back(channel);
    }
    model.animations.push_back(clip);
    if (seeThrough) {
        Material& glass = model.materials[0];
        glass.transparent = true;
        glass.transparency = 0.5f;
        glass.slot(Slot::Transparent) = {
            .present = true, .color = glm::vec4(1.0f), .texture = -1, .texCoordName = {}};
    }
    return std::make_shared<const Model>(std::move(model));
}

class CrowdRendererGLTest : public GlTest {
protected:
    static constexpr int kWalkers = 7;

    // Where and when the walkers are: far enough apart that none covers another.
    static glm::mat4 placement(int walker) {
        return glm::translate(glm::mat4(1.0f), {6.0f * static_cast<float>(walker) - 18.0f, 0.0f, 0.0f});
    }
    static double seconds(int walker) { return 0.13 * walker; }

    static Camera camera() {
        Bounds bounds;
        bounds.add({-22.0f, -3.0f, -3.0f});
        bounds.add({22.0f, 3.0f, 3.0f});
        return Camera::framing(bounds, 4.0f, CameraPreset::Front);
    }

    // A model that stands elsewhere: its skeleton's root is there.
    static std::shared_ptr<const Model> moved(const Model& model, const glm::mat4& placement) {
        Model there = model;
        there.skeleton.rootTransform = placement * there.skeleton.rootTransform;
        return std::make_shared<const Model>(std::move(there));
    }

    Image oneByOne(const std::shared_ptr<const Model>& model, const RenderOptions& options) {
        Framebuffer picture(256, 64);
        renderer_.clear(picture, options);
        for (int walker = 0; walker < kWalkers; ++walker) {
            AnimatedModel single(moved(*model, placement(walker)));
            single.doAnimation(single.animations().front());
            single.setTime(seconds(walker));
            renderer_.draw(single, camera(), picture, options);
        }
        return picture.read();
    }

    Image together(const std::shared_ptr<const Model>& model, const RenderOptions& options,
                   std::size_t maxTexels = BufferTexture::maxTexels()) {
        Framebuffer picture(256, 64);
        renderer_.clear(picture, options);
        AnimatedModel walker(model);
        walker.doAnimation(walker.animations().front());
        const std::size_t joints = jointsPerWalker(*model);
        std::vector<JointRows> palettes;
        for (int i = 0; i < kWalkers; ++i) {
            walker.setTime(seconds(i));
            appendPalette(walker, palettes);
            place(std::span(palettes).last(joints), placement(i));
        }
        CrowdRenderer crowd(maxTexels);
        crowd.draw(walker, palettes, camera(), picture, options);
        return picture.read();
    }

    // How many of the bytes differ by more than rounding.
    static int differences(const Image& a, const Image& b) {
        int count = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i) count += std::abs(a.rgba[i] - b.rgba[i]) > 1;
        return count;
    }

    AnimatedModelRenderer renderer_;
};

TEST_F(CrowdRendererGLTest, aCrowdLooksAsIfItsWalkersWereDrawnOneByOne) {
    for (const bool seeThrough : {false, true}) {
        for (const Lighting lights : {Lighting::Studio, Lighting::File}) {
            const RenderOptions options{.lights = lights, .background = Background::Transparent};
            const auto model = dancer(seeThrough);
            const Image single = oneByOne(model, options), crowd = together(model, options);
            keep(crowd, seeThrough ? "crowd-glass" : "crowd");
            int covered = 0;
            for (std::size_t i = 3; i < single.rgba.size(); i += 4) covered += single.rgba[i] > 0;
            EXPECT_GT(covered, 500);
            EXPECT_LE(differences(single, crowd), 4);
        }
    }
}

TEST_F(CrowdRendererGLTest, walkersThatDoNotFitOneTextureAreDrawnInSeveralCalls) {
    const auto model = dancer();
    const std::size_t texelsAWalker = jointsPerWalker(*model) * 3;
    const Image whole = together(model, {});
    EXPECT_EQ(together(model, {}, texelsAWalker).rgba, whole.rgba);
    EXPECT_EQ(together(model, {}, texelsAWalker * 3 + 2).rgba, whole.rgba);
}

TEST_F(CrowdRendererGLTest, aWalkerThatFitsNoTextureIsAnError) {
    const auto model = dancer();
    EXPECT_THROW(together(model, {}, jointsPerWalker(*model) * 3 - 1), GraphicsError);
}

TEST_F(CrowdRendererGLTest, nobodyIsDrawnOfAnEmptyCrowd) {
    const auto model = dancer();
    Framebuffer picture(32, 32);
    renderer_.clear(picture, {.background = Background::Transparent});
    CrowdRenderer().draw(AnimatedModel(model), {}, camera(), picture);
    EXPECT_EQ(pixel(picture.read(), 16, 16)[3], 0);
}

}  // namespace
}  // namespace walkcycle
