#include "render/GlTest.h"
#include "render/InstanceStates.h"
#include "render/TestModels.h"

namespace walkcycle {
namespace {

using namespace testing_models;

class InstanceStatesGLTest : public GlTest {
protected:
    static void expectPositionsOfThePose(const AnimatedModel& model) {
        InstanceStates states;
        states.prepare(model);
        std::vector<glm::vec3> positions;
        CpuSkinning().positions(model.model(), model.model().instances[0], model.animator().modelTransforms(),
                                {}, positions);
        for (std::uint32_t p = 0; p < positions.size(); ++p) {
            const glm::vec3 found = states.position(model, 0, p);
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(found[axis], positions[p][axis], 1e-5f) << p << " " << axis;
        }
    }
};

TEST_F(InstanceStatesGLTest, positionsFollowJointsAndNodes) {
    expectPositionsOfThePose(AnimatedModel(skinned(9, 7)));
    expectPositionsOfThePose(AnimatedModel(rigid(ball(), glm::mat4(glm::mat3(2.0f)))));
}

TEST_F(InstanceStatesGLTest, eachInstanceHasItsPaletteBehindTheOneBefore) {
    Model data = skinned(5, 2);
    data.instances.push_back(data.instances[0]);
    const AnimatedModel model(data);
    InstanceStates states;
    for (int picture = 0; picture < 2; ++picture) {
        states.prepare(model);
        EXPECT_EQ(states.states()[0].deform.firstJoint, 0);
        EXPECT_EQ(states.states()[1].deform.firstJoint, 6);  // five joints and the skin's node
    }
}

TEST_F(InstanceStatesGLTest, whatIsHiddenHasNoPalette) {
    Model data = skinned(5, 2);
    data.nodeVisible[0] = false;
    InstanceStates states;
    states.prepare(AnimatedModel(data));

    EXPECT_FALSE(states.states()[0].visible);
    EXPECT_EQ(states.states()[0].palette.jointCount, 0u);
}

TEST_F(InstanceStatesGLTest, theAreaHoldsWhatIsInThePicture) {
    const AnimatedModel model(skinned(9, 7));
    const Camera camera = Camera::framing(model.bounds(), 1.0f);
    InstanceStates states;
    states.prepare(model);
    const glm::ivec4 area = states.area(model, camera, RenderTarget{0, 400, 400}).pixels();

    for (std::uint32_t p = 0; p < model.model().meshes[0].positions.size(); ++p) {
        const glm::vec4 clip = camera.viewProjection() * glm::vec4(states.position(model, 0, p), 1.0f);
        const glm::vec2 pixel = (glm::vec2(clip) / clip.w * 0.5f + 0.5f) * 400.0f;
        EXPECT_TRUE(pixel.x >= static_cast<float>(area.x) && pixel.x <= static_cast<float>(area.z + 1) &&
                    pixel.y >= static_cast<float>(area.y) && pixel.y <= static_cast<float>(area.w + 1))
            << p;
    }
    EXPECT_LT(area.z - area.x, 399);  // framed with a margin
}

}  // namespace
}  // namespace walkcycle
