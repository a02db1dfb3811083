#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "render/GlTest.h"
#include "render/ModelResource.h"
#include "render/TestModels.h"

namespace walkcycle {
namespace {

using namespace testing_models;

class ModelResourceGLTest : public GlTest {};

// Adds a picture of one texel, and gives its index.
int addPicture(Model& model) {
    Texture texture;
    texture.image = std::make_shared<const Image>(
        Image{.width = 1, .height = 1, .hasAlpha = false, .rgba = {255, 255, 255, 255}});
    model.textures.push_back(texture);
    return static_cast<int>(model.textures.size()) - 1;
}

// A second instance of the first one's mesh.
Model twice(Model model) {
    model.instances.push_back(model.instances[0]);
    return model;
}

TEST_F(ModelResourceGLTest, aRigidMeshIsDrawnInOneCallPerPart) {
    const ModelResource resource(rigid(square()));
    ASSERT_EQ(resource.instances().size(), 1u);
    const ModelResource::Instance& instance = resource.instances()[0];
    EXPECT_FALSE(instance.deformedOnCpu);
    EXPECT_EQ(instance.skin, -1);
    ASSERT_EQ(instance.parts.size(), 1u);
    EXPECT_EQ(instance.parts[0].firstIndex, 0u);
    EXPECT_EQ(instance.parts[0].indexCount, 6u);
    EXPECT_EQ(instance.parts[0].material, 0);
    EXPECT_EQ(resource.needs(), ShaderNeeds{});
}

TEST_F(ModelResourceGLTest, instancesOfAMeshShareItsVertexArray) {
    const ModelResource resource(twice(rigid(square())));
    EXPECT_EQ(resource.instances()[0].parts[0].vao, resource.instances()[1].parts[0].vao);
}

TEST_F(ModelResourceGLTest, instancesOfASkinShareItsInfluences) {
    const ModelResource resource(twice(skinned(5, 3)));
    const auto& instances = resource.instances();
    ASSERT_TRUE(instances[0].influenceBuffers);
    EXPECT_EQ(instances[0].influenceBuffers, instances[1].influenceBuffers);
    EXPECT_EQ(instances[0].influenceBuffers->count, 3);
    EXPECT_EQ(instances[0].parts[0].vao, instances[1].parts[0].vao);
}

TEST_F(ModelResourceGLTest, onlyMoreThanFourInfluencesNeedTheirTexture) {
    EXPECT_FALSE(ModelResource(skinned(9, 4)).needs().moreInfluences);
    EXPECT_TRUE(ModelResource(skinned(9, 5)).needs().moreInfluences);
}

TEST_F(ModelResourceGLTest, aRigidAndASkinnedInstanceOfAMeshHaveVertexArraysOfTheirOwn) {
    Model model = twice(skinned(5, 3));
    model.instances[1].deformers.clear();
    const ModelResource resource(model);
    EXPECT_NE(resource.instances()[0].parts[0].vao, resource.instances()[1].parts[0].vao);
    EXPECT_EQ(resource.instances()[1].influenceBuffers, nullptr);
}

TEST_F(ModelResourceGLTest, leadingMorphsAreLeftToTheShader) {
    Model model = skinned(5, 3);
    addMorph(model, MorphMethod::Relative, {0.5f});
    addMorph(model, MorphMethod::Normalized, {0.5f});
    const ModelResource resource(model);
    EXPECT_EQ(resource.instances()[0].morphCount, 2u);
    EXPECT_TRUE(resource.instances()[0].morphBuffers);
    EXPECT_EQ(resource.instances()[0].skin, 0);
    EXPECT_TRUE(resource.needs().morphs);
}

TEST_F(ModelResourceGLTest, aMorphOfASkinnedMeshIsDeformedOnTheCpuInBuffersOfItsOwn) {
    Model model = skinned(5, 3);
    addMorph(model, MorphMethod::Relative, {0.5f});
    std::swap(model.instances[0].deformers[0], model.instances[0].deformers[1]);
    const ModelResource resource(twice(model));
    for (const ModelResource::Instance& instance : resource.instances()) {
        EXPECT_TRUE(instance.deformedOnCpu);
        EXPECT_TRUE(instance.deformed);
        EXPECT_EQ(instance.skin, -1);
    }
    EXPECT_NE(resource.instances()[0].parts[0].vao, resource.instances()[1].parts[0].vao);
}

TEST_F(ModelResourceGLTest, whatIsLargerThanATextureBufferIsDeformedOnTheCpu) {
    const Model jointsAlone = skinned(30, 4);  // and the skin's own node
    EXPECT_TRUE(ModelResource(jointsAlone, 30 * 3).instances()[0].deformedOnCpu);
    EXPECT_FALSE(ModelResource(jointsAlone, 31 * 3).instances()[0].deformedOnCpu);

    Model morphed = rigid(square());
    addMorph(morphed, MorphMethod::Relative, {0.5f, 0.5f});
    EXPECT_TRUE(ModelResource(morphed, 7).instances()[0].deformedOnCpu);  // two targets of four positions
    EXPECT_FALSE(ModelResource(morphed, 8).instances()[0].deformedOnCpu);

    const Model influences = skinned(9, 5);  // one beyond four for each position
    const std::size_t positions = influences.meshes[0].positions.size();
    EXPECT_TRUE(ModelResource(influences, positions - 1).instances()[0].deformedOnCpu);
    EXPECT_FALSE(ModelResource(influences, positions).instances()[0].deformedOnCpu);
}

TEST_F(ModelResourceGLTest, aPictureIsKeptInTheFormThatItsSlotNeeds) {
    Model model = rigid(square());
    const int color = addPicture(model), bump = addPicture(model);
    model.materials[0].slot(Slot::Diffuse).texture = color;
    model.materials[0].slot(Slot::Bump).texture = bump;
    const ModelResource resource(model);
    EXPECT_TRUE(resource.texture(color, Slot::Diffuse));
    EXPECT_FALSE(resource.texture(color, Slot::Bump));
    EXPECT_TRUE(resource.texture(bump, Slot::Bump));
    EXPECT_FALSE(resource.texture(bump, Slot::Diffuse));
    EXPECT_TRUE(resource.needs().bumped);
    EXPECT_EQ(resource.needs().texturedSlots,
              1u << static_cast<unsigned>(Slot::Diffuse) | 1u << static_cast<unsigned>(Slot::Bump));
}

TEST_F(ModelResourceGLTest, aTextureWithoutAPictureIsNone) {
    Model model = rigid(square());
    model.textures.emplace_back();
    model.materials[0].slot(Slot::Diffuse).texture = 0;
    const ModelResource resource(model);
    EXPECT_FALSE(resource.texture(0, Slot::Diffuse));
    EXPECT_FALSE(resource.texture(-1, Slot::Diffuse));
    EXPECT_FALSE(resource.texture(7, Slot::Diffuse));
    EXPECT_EQ(resource.needs().texturedSlots, 0u);
}

TEST_F(ModelResourceGLTest, partsWhosePicturesUseOtherCoordinatesHaveOtherVertexArrays) {
    MeshData mesh = square();
    mesh.texCoordSets.push_back({.set = 1, .coords = std::vector<glm::vec2>(4, {0.5f, 0.5f})});
    Model model = twice(rigid(mesh));
    model.materials[0].slot(Slot::Diffuse).texture = addPicture(model);
    constexpr auto kDiffuse = static_cast<std::size_t>(Slot::Diffuse),
                   kSpecular = static_cast<std::size_t>(Slot::Specular);
    model.instances[1].materials[0].texCoordSets[kSpecular] = 1;  // has no picture
    EXPECT_EQ(ModelResource(model).instances()[0].parts[0].vao,
              ModelResource(model).instances()[1].parts[0].vao);
    model.instances[1].materials[0].texCoordSets[kDiffuse] = 1;
    const ModelResource resource(model);
    EXPECT_NE(resource.instances()[0].parts[0].vao, resource.instances()[1].parts[0].vao);
    EXPECT_FALSE(resource.needs().separateCoords);
}

TEST_F(ModelResourceGLTest, aPartWithPicturesOnTwoSetsOfCoordinatesNeedsSeparateOnes) {
    MeshData mesh = square();
    mesh.texCoordSets.push_back({.set = 1, .coords = std::vector<glm::vec2>(4, {0.5f, 0.5f})});
    Model model = rigid(mesh);
    model.materials[0].slot(Slot::Diffuse).texture = addPicture(model);
    model.materials[0].slot(Slot::Specular).texture = addPicture(model);
    EXPECT_FALSE(ModelResource(model).needs().separateCoords);
    model.instances[0].materials[0].texCoordSets[static_cast<std::size_t>(Slot::Specular)] = 1;
    EXPECT_TRUE(ModelResource(model).needs().separateCoords);
}

// A square and, far to the right, a triangle: the position nearest to the middle of each part.
TEST_F(ModelResourceGLTest, aPartThatMayShowThroughIsSortedByThePositionNearestToItsMiddle) {
    MeshData mesh = square();
    mesh.positions.push_back({0.1f, 0.0f, 0.0f});
    mesh.vertexPositions.push_back(4);
    mesh.normals.push_back({0, 0, 1});
    mesh.texCoordSets[0].coords.push_back({0, 0});
    mesh.indices = {0, 1, 4, 2, 3, 4};
    Model model = rigid(mesh);
    EXPECT_FALSE(ModelResource(model).needs().seeThrough);
    model.materials[0].transparent = true;
    const ModelResource resource(model);
    EXPECT_TRUE(resource.needs().seeThrough);
    EXPECT_EQ(resource.instances()[0].parts[0].middle, 4u);
}

TEST_F(ModelResourceGLTest, aMaterialThatAnAnimationMayFadeCountsAsShowingThrough) {
    Model model = rigid(square());
    model.parameters.push_back(
        {.kind = ParameterKind::LightColor, .object = 0, .component = 0, .restValue = 1});
    EXPECT_FALSE(ModelResource(model).needs().seeThrough);
    model.parameters.push_back(
        {.kind = ParameterKind::MaterialValue, .object = 0, .component = 0, .restValue = 1});
    EXPECT_TRUE(ModelResource(model).needs().seeThrough);
}

TEST_F(ModelResourceGLTest, thereIsABoxForEachMatrixUnlessSomethingElseMovesTheMesh) {
    EXPECT_EQ(ModelResource(rigid(square())).instances()[0].boxes.size(), 1u);
    EXPECT_EQ(ModelResource(skinned(5, 3)).instances()[0].boxes.size(), 6u);
    Model morphed = rigid(square());
    addMorph(morphed, MorphMethod::Relative, {0.5f});
    EXPECT_TRUE(ModelResource(morphed).instances()[0].boxes.empty());
}

}  // namespace
}  // namespace walkcycle
