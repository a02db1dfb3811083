#include <cmath>
#include <cstdint>
#include <cstdio>

#include <unistd.h>

#include "render/GlTest.h"
#include "walkcycle/animation/Animator.h"
#include "walkcycle/io/File.h"
#include "walkcycle/loaders/ColladaLoader.h"
#include "walkcycle/render/AnimatedModel.h"
#include "walkcycle/render/AnimatedModelRenderer.h"
#include "walkcycle/render/Camera.h"
#include "walkcycle/render/Framebuffer.h"

// What runs for days: here it runs for minutes, and must end as it began.
namespace walkcycle {
namespace {

constexpr const char* kArm = WALKCYCLE_FIXTURES "/two-bone-arm.dae";  // skinned and animated, and small

// What of this program is in memory, in bytes.
std::int64_t residentBytes() {
    long pages = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "r");
    if (!file || std::fscanf(file, "%*d %ld", &pages) != 1) pages = -1;
    if (file) std::fclose(file);
    return std::int64_t{pages} * ::sysconf(_SC_PAGESIZE);
}

TEST(SoakTest, tenMillionUpdatesLoseNoTimeAndNoMemory) {
    constexpr int kUpdates = 10'000'000;
    constexpr double kStep = 1.0 / 60.0;
    Model model;
    model.skeleton.joints.resize(2);
    model.skeleton.joints[1].parent = 0;
    Animation clip;
    clip.startSeconds = 1.0;
    clip.endSeconds = 1.96;
    clip.channels = {{.joint = 1, .keyFrames = {{1.0, {}}, {1.96, {.position = {2.0f, 0.0f, 0.0f}}}}}};
    Animator animator(model.skeleton);
    animator.doAnimation(clip);

    const std::int64_t before = residentBytes();
    for (int i = 0; i < kUpdates; ++i) animator.update(kStep);

    EXPECT_NEAR(animator.time(), std::fmod(kUpdates * kStep, clip.lengthInSeconds()), 1e-6);
    EXPECT_NEAR(animator.modelTransforms()[1][3].x, 2.0 * animator.time() / clip.lengthInSeconds(), 1e-5);
    EXPECT_LE(residentBytes() - before, 1 << 20);
}

class SoakGLTest : public GlTest {};

TEST_F(SoakGLTest, aHundredThousandFramesLeaveTheMemoryAsItWasAndEndWithTheSamePicture) {
    constexpr int kFrames = 100'000, kWarmUp = 2'000;
    AnimatedModel model(loadCollada(kArm));
    AnimatedModelRenderer renderer;
    Framebuffer picture(8, 8);
    const Camera camera = Camera::framing(model.bounds(), picture.aspect());
    model.doAnimation(model.animations().front());
    const auto draw = [&](double seconds) {
        model.setTime(seconds);
        renderer.render(model, camera, picture);
        return picture.read();
    };

    const Image first = draw(0.7);
    std::int64_t before = 0;
    for (int i = 0; i < kFrames; ++i) {
        if (i == kWarmUp) before = residentBytes();
        model.update(1.0 / 30.0);
        renderer.render(model, camera, picture);
        if (i % 100 == 0) picture.read();
    }
    EXPECT_LE(residentBytes() - before, 8 << 20);
    EXPECT_EQ(draw(0.7).rgba, first.rgba);
}

}  // namespace
}  // namespace walkcycle
