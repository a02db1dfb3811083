#include <utility>

#include "render/GlTest.h"
#include "render/TestModels.h"
#include "walkcycle/render/AnimatedModel.h"

namespace walkcycle {
namespace {

using namespace testing_models;

// The model keeps a pointer to its clip, which must not be a temporary.
template <class Clip>
concept CanPlay = requires(AnimatedModel& model, Clip&& clip) {
    model.doAnimation(std::forward<Clip>(clip));
};
static_assert(CanPlay<Animation&> && CanPlay<const Animation&>);
static_assert(!CanPlay<Animation> && !CanPlay<const Animation>);

class AnimatedModelGLTest : public GlTest {
protected:
    // A square whose node and whose material's shininess both count the seconds of a clip of two.
    static Model counting() {
        Model model = rigid(square());
        model.materials = {Material{}};
        model.parameters = {{.kind = ParameterKind::MaterialValue,
                             .component = static_cast<int>(MaterialComponent::Shininess)}};
        Animation clip;
        clip.endSeconds = 2.0;
        clip.channels = {{.joint = 0, .keyFrames = {{0.0, {}}, {2.0, {.position = {0.0f, 2.0f, 0.0f}}}}}};
        clip.parameterTracks = {{.parameter = 0, .keyFrames = {{0.0, 0.0f}, {2.0, 2.0f}}}};
        model.animations = {clip};
        return model;
    }

    static void expectTime(const AnimatedModel& model, float seconds) {
        EXPECT_FLOAT_EQ(static_cast<float>(model.animator().time()), seconds);
        EXPECT_FLOAT_EQ(model.animator().modelTransforms()[0][3].y, seconds);
        EXPECT_FLOAT_EQ(model.scene().materials[0].shininess, seconds);
    }
};

TEST_F(AnimatedModelGLTest, jointsAndMaterialsAreOfTheSameTime) {
    AnimatedModel model(counting());
    model.doAnimation(model.animations().front());
    expectTime(model, 0.0f);
    model.update(0.75);
    expectTime(model, 0.75f);
    model.setTime(1.25);
    expectTime(model, 1.25f);
    model.step(0.25);
    expectTime(model, 1.5f);
    model.sampleAt(2.0);
    expectTime(model, 2.0f);
}

TEST_F(AnimatedModelGLTest, speedAndLoopModeAreTheAnimators) {
    AnimatedModel model(counting());
    model.doAnimation(model.animations().front());
    model.setLoopMode(LoopMode::PingPong);
    model.setSpeed(2.0);
    model.update(1.25);
    expectTime(model, 1.5f);
}

}  // namespace
}  // namespace walkcycle
