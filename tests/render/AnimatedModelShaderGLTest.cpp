#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/AnimatedModelShader.h"
#include "render/GlTest.h"
#include "render/TestModels.h"
#include "render/VertexCapture.h"
#include "walkcycle/model/CpuSkinning.h"

namespace walkcycle {
namespace {

using namespace testing_models;

// What the GPU makes of every vertex against CpuSkinning, as a share of the model's size.
void expectGpuEqualsCpu(const Model& model) {
    AnimatedModel animated(model);
    ASSERT_FALSE(animated.resource()->instances()[0].deformedOnCpu);
    VertexCapture gpu;
    const auto vertices = gpu.capture(animated, 0);
    std::vector<glm::vec3> positions, normals;
    CpuSkinning().vertices(model, model.instances[0], animated.animator().modelTransforms(),
                           animated.animator().parameters(), positions, normals);
    ASSERT_EQ(vertices.positions.size(), positions.size());
    float positionError = 0.0f, normalError = 0.0f;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        positionError = std::max(positionError, glm::length(vertices.positions[v] - positions[v]));
        normalError = std::max(normalError, glm::length(vertices.normals[v] - normals[v]));
    }
    EXPECT_LT(positionError / animated.bounds().diagonal(), 1e-5f);
    EXPECT_LT(normalError, 1e-4f);
}

class AnimatedModelShaderGLTest : public GlTest {};

TEST_F(AnimatedModelShaderGLTest, rigidMeshStandsAtItsNode) {
    const glm::mat4 transform = glm::translate(glm::mat4(1.0f), {3.0f, -2.0f, 1.0f});
    expectGpuEqualsCpu(
        rigid(ball(), glm::scale(glm::rotate(transform, 0.7f, {1, 1, 0}), {1.0f, 2.0f, 0.3f})));
}

TEST_F(AnimatedModelShaderGLTest, fourInfluencesAreSummed) {
    expectGpuEqualsCpu(skinned(9, 4));
}

TEST_F(AnimatedModelShaderGLTest, sevenInfluencesAreSummedNoneDropped) {
    expectGpuEqualsCpu(skinned(9, 7));
}

TEST_F(AnimatedModelShaderGLTest, threeHundredJointsFitThePalette) {
    expectGpuEqualsCpu(skinned(300, 5));
}

TEST_F(AnimatedModelShaderGLTest, unweightedPositionsFollowTheSkinsNode) {
    Model model = skinned(4, 1);
    model.skeleton.joints[0].localBindTransform = glm::translate(glm::mat4(1.0f), {5.0f, 0.0f, 0.0f});
    const auto own = static_cast<std::uint32_t>(model.skins[0].joints.size() - 1);
    for (std::size_t i = 0; i < model.influences[0].influences.size(); i += 2)
        model.influences[0].influences[i] = {own, 1.0f};
    expectGpuEqualsCpu(model);
}

TEST_F(AnimatedModelShaderGLTest, morphComesBeforeSkin) {
    Model model = skinned(6, 4);
    addMorph(model, MorphMethod::Normalized, {0.4f, 0.0f, 0.3f});
    expectGpuEqualsCpu(model);
}

TEST_F(AnimatedModelShaderGLTest, morphOnMorphIsSummedInOrder) {
    Model model = rigid(ball());
    addMorph(model, MorphMethod::Relative, {0.5f});
    addMorph(model, MorphMethod::Normalized, {0.25f, 0.5f});
    expectGpuEqualsCpu(model);
}

TEST_F(AnimatedModelShaderGLTest, mirroredNodeTurnsNormalsOutwards) {
    expectGpuEqualsCpu(rigid(ball(), glm::scale(glm::mat4(1.0f), {-1.0f, 2.0f, 0.5f})));
}

TEST_F(AnimatedModelShaderGLTest, textureBuffersTooSmallForASkinLeaveItToTheCpu) {
    const Model model = skinned(30, 7);
    const ModelResource resource(model, 64);
    EXPECT_TRUE(resource.instances()[0].deformedOnCpu);
}

}  // namespace
}  // namespace walkcycle
