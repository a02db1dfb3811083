#include <cstdint>
#include <utility>
#include <vector>

#include "render/GlTest.h"
#include "render/InstanceStates.h"
#include "render/TestModels.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

using namespace testing_models;

class InstanceStatesGLTest : public GlTest {
protected:
    const InstanceStates& prepared(const AnimatedModel& model) {
        states_.prepare(model);
        return states_;
    }

    InstanceStates states_;
};

glm::mat4 at(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), {x, y, z});
}

// A square on a node, and a second one on a node of its own.
Model twoSquares() {
    Model model = rigid(square(), at(1, 2, 3));
    model.skeleton.joints.push_back(node(at(7, 0, 0)));
    model.nodeVisible = {true, true};
    model.instances.push_back(model.instances[0]);
    model.instances[1].node = 1;
    return model;
}

// Morphs that come after a skin are beyond the shader.
Model deformedOnCpu() {
    Model model = skinned(5, 4);
    addMorph(model, MorphMethod::Relative, {0.5f});
    std::swap(model.instances[0].deformers[0], model.instances[0].deformers[1]);
    return model;
}

TEST_F(InstanceStatesGLTest, aRigidMeshFollowsItsNode) {
    const AnimatedModel model(twoSquares());
    const InstanceStates& states = prepared(model);
    EXPECT_EQ(states.position(model, 0, 2), glm::vec3(2, 3, 3));  // (1, 1, 0) of the square
    EXPECT_EQ(states.position(model, 1, 2), glm::vec3(8, 1, 0));
}

TEST_F(InstanceStatesGLTest, aSkinnedPositionIsWhereTheCpuPutsIt) {
    const Model skin = skinned(9, 7);
    const AnimatedModel model(skin);
    const InstanceStates& states = prepared(model);
    std::vector<glm::vec3> expected;
    CpuSkinning().positions(skin, skin.instances[0], model.animator().modelTransforms(), {}, expected);
    for (std::uint32_t p = 0; p < expected.size(); ++p)
        EXPECT_LT(glm::length(states.position(model, 0, p) - expected[p]), 1e-5f) << p;
}

TEST_F(InstanceStatesGLTest, eachInstanceHasAPaletteOfItsOwn) {
    const AnimatedModel model(twoSquares());
    prepared(model);
    EXPECT_EQ(states_.bind(model, 0).firstJoint, 0);
    EXPECT_EQ(states_.bind(model, 1).firstJoint, 1);
    EXPECT_EQ(states_.bind(model, 1).jointsPerWalker, 0);
}

TEST_F(InstanceStatesGLTest, aHiddenInstanceTakesNoPlaceInThePalette) {
    Model hidden = twoSquares();
    hidden.nodeVisible = {false, true};
    const AnimatedModel model(hidden);
    const InstanceStates& states = prepared(model);
    EXPECT_FALSE(states.states()[0].visible);
    EXPECT_TRUE(states.states()[1].visible);
    EXPECT_EQ(states.bind(model, 1).firstJoint, 0);
}

TEST_F(InstanceStatesGLTest, theShaderIsToldTheMostInfluencesOfAVertexAndTheSizesOfItsMesh) {
    const AnimatedModel two(skinned(9, 2)), seven(skinned(9, 7)), rigidBall(rigid(ball()));
    EXPECT_EQ(prepared(two).bind(two, 0).influenceCount, 2);
    EXPECT_EQ(prepared(seven).bind(seven, 0).influenceCount, 4);
    const DeformUniforms::Values& values = prepared(rigidBall).bind(rigidBall, 0);
    EXPECT_EQ(values.influenceCount, 1);
    EXPECT_EQ(values.positionCount, 13 * 17);
    EXPECT_EQ(values.vertexCount, 2 * 13 * 17);
}

TEST_F(InstanceStatesGLTest, onlyMorphTargetsWithAWeightAreListed) {
    Model first = rigid(ball());
    addMorph(first, MorphMethod::Relative, {0.0f, 0.25f, 0.0f, 0.5f});
    first.instances.push_back(first.instances[0]);
    const AnimatedModel model(first);
    const InstanceStates& states = prepared(model);
    EXPECT_EQ(states.bind(model, 0).morphRange, glm::ivec2(0, 2));
    EXPECT_EQ(states.bind(model, 1).morphRange, glm::ivec2(2, 4));
}

TEST_F(InstanceStatesGLTest, whatTheCpuDeformsIsUploadedAsItIsInModelSpace) {
    const Model deformed = deformedOnCpu();
    const AnimatedModel model(deformed);
    prepared(model);
    ASSERT_TRUE(model.resource()->instances()[0].deformedOnCpu);
    std::vector<glm::vec3> positions, normals;
    CpuSkinning().vertices(deformed, deformed.instances[0], model.animator().modelTransforms(),
                           model.animator().parameters(), positions, normals);
    std::vector<glm::vec3> uploaded(positions.size());
    glBindBuffer(GL_ARRAY_BUFFER, model.resource()->instances()[0].deformed->positions.id());
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(uploaded.size() * sizeof(glm::vec3)),
                       uploaded.data());
    EXPECT_EQ(uploaded, positions);
}

TEST_F(InstanceStatesGLTest, aPictureHoldsNothingOfTheOneBefore) {
    const AnimatedModel large(skinned(30, 5)), small(twoSquares());
    prepared(large);
    const InstanceStates& states = prepared(small);
    EXPECT_EQ(states.states().size(), 2u);
    EXPECT_EQ(states.bind(small, 0).firstJoint, 0);
    EXPECT_EQ(states.position(small, 0, 2), glm::vec3(2, 3, 3));
}

TEST_F(InstanceStatesGLTest, theAreaIsThatOfWhatIsVisible) {
    Model squares = twoSquares();
    squares.skeleton.joints[0].localBindTransform =
        at(-0.5f, 0, 0) * glm::scale(glm::mat4(1), glm::vec3(0.11f));
    squares.skeleton.joints[1].localBindTransform =
        at(0.5f, 0, 0) * glm::scale(glm::mat4(1), glm::vec3(0.11f));
    const RenderTarget target{.framebuffer = 0, .width = 100, .height = 100};
    const Camera camera;  // clip space is model space
    const AnimatedModel both(squares);
    EXPECT_EQ(prepared(both).area(both, camera, target).pixels(), glm::ivec4(16, 41, 83, 58));
    squares.nodeVisible = {false, true};
    const AnimatedModel right(squares);
    EXPECT_EQ(prepared(right).area(right, camera, target).pixels(), glm::ivec4(66, 41, 83, 58));
}

TEST_F(InstanceStatesGLTest, theAreaIsTheWholePictureIfTheCpuDeforms) {
    const AnimatedModel model(deformedOnCpu());
    const RenderTarget target{.framebuffer = 0, .width = 100, .height = 100};
    EXPECT_EQ(prepared(model).area(model, Camera(), target).pixels(), ScreenArea::whole().pixels());
}

}  // namespace
}  // namespace walkcycle
