#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "model/Deformers.h"

namespace walkcycle {
namespace {

constexpr Deformer kSkin{Deformer::Kind::Skin, 0, 0};
constexpr Deformer morphOf(int index) {
    return {Deformer::Kind::Morph, index, 0};
}

// Adds a morph with so many targets.
void addMorph(Model& model, MorphMethod method, int firstParameter, std::size_t targets) {
    MorphTargets morph;
    morph.method = method;
    morph.firstParameter = firstParameter;
    morph.targets.resize(targets);
    model.morphs.push_back(morph);
}

TEST(DeformersTest, aNormalizedLayerScalesWhatLiesBeneath) {
    Model model;
    addMorph(model, MorphMethod::Relative, 0, 2);
    addMorph(model, MorphMethod::Normalized, 2, 2);
    const std::vector<Deformer> deformers{morphOf(0), morphOf(1)};
    std::vector<float> coefficients;
    morphCoefficients(model, deformers, std::vector<float>{1.0f, 0.5f, 0.25f, 0.25f}, coefficients);

    EXPECT_EQ(coefficients, (std::vector<float>{0.5f, 0.25f, 0.25f, 0.25f}));
}

TEST(DeformersTest, aRelativeLayerLeavesWhatLiesBeneath) {
    Model model;
    addMorph(model, MorphMethod::Normalized, 0, 1);
    addMorph(model, MorphMethod::Relative, 1, 1);
    const std::vector<Deformer> deformers{morphOf(0), morphOf(1)};
    std::vector<float> coefficients;
    morphCoefficients(model, deformers, std::vector<float>{0.5f, 2.0f}, coefficients);

    EXPECT_EQ(coefficients, (std::vector<float>{0.5f, 2.0f}));
}

TEST(DeformersTest, theShaderDoesMorphsAndThenOneSkinAndNothingElse) {
    Model model;
    model.meshes.emplace_back();
    MeshInstance instance;
    EXPECT_TRUE(shaderCanDeform(model, instance));
    instance.deformers = {morphOf(0), morphOf(1), kSkin};
    EXPECT_TRUE(shaderCanDeform(model, instance));
    instance.deformers = {morphOf(0)};
    EXPECT_TRUE(shaderCanDeform(model, instance));
    instance.deformers = {kSkin, morphOf(0)};
    EXPECT_FALSE(shaderCanDeform(model, instance));
    instance.deformers = {kSkin, kSkin};
    EXPECT_FALSE(shaderCanDeform(model, instance));
}

TEST(DeformersTest, onlyNormalizedLayersTakeFromTheirInput) {
    Model model;
    addMorph(model, MorphMethod::Normalized, 0, 2);
    addMorph(model, MorphMethod::Relative, 2, 1);
    const std::vector<Deformer> deformers{morphOf(0), morphOf(1)};
    EXPECT_FLOAT_EQ(shareOfInput(model, deformers, std::vector<float>{0.25f, 0.5f, 0.5f}), 0.25f);
}

// A deformed mesh whose file has no normals.
TEST(DeformersTest, normalsThatAreMadeForEachShapeAreNotTheShadersBusiness) {
    Model model;
    model.meshes.emplace_back();
    model.meshes[0].madeNormals.faces.rings = {{.firstCorner = 0, .cornerCount = 3}};
    MeshInstance instance;
    EXPECT_FALSE(makesNormals(model, instance)) << "nothing deforms it";
    EXPECT_TRUE(shaderCanDeform(model, instance));
    instance.deformers = {kSkin};
    EXPECT_TRUE(makesNormals(model, instance));
    EXPECT_FALSE(shaderCanDeform(model, instance));
    model.meshes[0].tangents = {{1, 0, 0, 1}};
    EXPECT_FALSE(makesNormals(model, instance)) << "its bump texture needs the tangents";
    EXPECT_TRUE(shaderCanDeform(model, instance));
}

}  // namespace
}  // namespace walkcycle
