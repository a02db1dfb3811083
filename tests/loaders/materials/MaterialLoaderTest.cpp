#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "loaders/MaterialsOf.h"
#include "loaders/materials/MaterialLoader.h"

namespace walkcycle {
namespace {

class MaterialLoaderTest : public testing::Test {
protected:
    static int setOf(const PartMaterial& bound, Slot slot) {
        return bound.texCoordSets[static_cast<std::size_t>(slot)];
    }

    MaterialsOf file{MaterialsOf::fixture("material-textures.dae")};
};

TEST_F(MaterialLoaderTest, theInstanceSaysWhichMaterialASymbolIs) {
    const PartMaterial bound = file.boundAt("both");

    ASSERT_GE(bound.material, 0);
    EXPECT_EQ(file.model.materials[static_cast<std::size_t>(bound.material)].id, "chain");
}

TEST_F(MaterialLoaderTest, aMaterialIsReadOnceHoweverOftenItIsBound) {
    EXPECT_EQ(file.boundAt("both").material, file.boundAt("names").material);
    EXPECT_EQ(file.model.materials.size(), 1u);
}

TEST_F(MaterialLoaderTest, theInstanceSaysWhichTexturesCoordinatesAre) {
    EXPECT_EQ(setOf(file.boundAt("both"), Slot::Diffuse), 0);
    EXPECT_EQ(setOf(file.boundAt("both"), Slot::Emission), -1);
}

TEST_F(MaterialLoaderTest, aSetThatIsNotThereIsTheFirstOne) {
    EXPECT_EQ(setOf(file.boundAt("both"), Slot::Bump), 0);
    EXPECT_EQ(file.notes(Code::TexCoordsGuessed), 1);
}

TEST_F(MaterialLoaderTest, withoutABindingTheNamesNumberSaysWhichSet) {
    EXPECT_EQ(setOf(file.boundAt("names"), Slot::Diffuse), 1);
    EXPECT_EQ(setOf(file.boundAt("names"), Slot::Bump), 0);
}

TEST_F(MaterialLoaderTest, aMeshWithoutTextureCoordinatesIsReported) {
    MeshData mesh = MaterialsOf::meshAsking("chain");
    mesh.texCoordSets.clear();
    const PartMaterial bound = file.loader.bind(file.root, mesh).at(0);

    EXPECT_EQ(setOf(bound, Slot::Diffuse), -1);
    EXPECT_EQ(file.warnings(Code::TexCoordsMissing), 1);
}

TEST_F(MaterialLoaderTest, aMaterialThatIsNotThereIsReportedWithItsSymbol) {
    EXPECT_EQ(file.boundAt("wrong").material, -1);
    ASSERT_EQ(file.warnings(Code::MaterialNotThere), 1);
    EXPECT_NE(file.diagnostics.all()[0].message.find("symbol=\"symbol\""), std::string::npos);
    EXPECT_GT(file.diagnostics.all()[0].line, 0);
}

TEST_F(MaterialLoaderTest, aSymbolThatNothingIsBoundToIsReported) {
    EXPECT_EQ(file.boundAt("none").material, -1);
    EXPECT_EQ(file.warnings(Code::MaterialUnbound), 1);
}

TEST_F(MaterialLoaderTest, withoutABindingAMaterialOfThatNameIsTaken) {
    EXPECT_EQ(file.material("direct").id, "direct");
    EXPECT_EQ(file.notes(Code::MaterialGuessed), 1);
}

TEST_F(MaterialLoaderTest, aPartThatAsksForNothingGetsNothing) {
    EXPECT_EQ(file.loader.bind(file.root, MaterialsOf::meshAsking("")).at(0).material, -1);
    EXPECT_TRUE(file.diagnostics.all().empty());
}

TEST_F(MaterialLoaderTest, meshesWithBumpsGetTangents) {
    MeshData mesh = MaterialsOf::meshAsking("chain");
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.vertexPositions = {0, 1, 2};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.texCoordSets = {{0, {{0, 0}, {1, 0}, {0, 1}}}};
    mesh.indices = {0, 1, 2};
    mesh.parts[0].indexCount = 3;
    file.model.instances.resize(2);
    file.model.instances[0].materials = file.loader.bind(file.root, mesh);
    file.model.meshes = {mesh, mesh};
    file.model.instances[1].mesh = 1;
    makeBumpTangents(file.model);

    ASSERT_EQ(file.model.meshes[0].tangents.size(), 3u);
    EXPECT_NEAR(file.model.meshes[0].tangents[0].x, 1.0f, 1e-5f);
    EXPECT_TRUE(file.model.meshes[1].tangents.empty());
}

TEST_F(MaterialLoaderTest, theUsersPictureStandsForEveryDiffuseOne) {
    LoadOptions options;
    options.texture = MaterialsOf::fixture("not-there.png");
    MaterialsOf withPictures(MaterialsOf::fixture("material-textures.dae"), options);
    EXPECT_EQ(withPictures.texture(withPictures.material("direct"), Slot::Diffuse).id, "skin-img");
    EXPECT_FALSE(withPictures.texture(withPictures.material("direct"), Slot::Diffuse).image);
    MaterialsOf without(MaterialsOf::fixture("material-slots.dae"), options);
    EXPECT_EQ(without.material("skin").slot(Slot::Diffuse).texture, 0);
    EXPECT_EQ(without.material("half").slot(Slot::Diffuse).texture, 0);
}

TEST_F(MaterialLoaderTest, animationsFindMaterialsByTheirElements) {
    const PartMaterial bound = file.boundAt("both");

    const auto found = file.loader.elements().find(file.root.elementById("chain-fx"));
    ASSERT_NE(found, file.loader.elements().end());
    EXPECT_EQ(found->second, bound.material);
}

}  // namespace
}  // namespace walkcycle
