#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "loaders/LoadText.h"
#include "loaders/MaterialsOf.h"
#include "loaders/materials/TextureReader.h"

namespace walkcycle {
namespace {

class TextureReaderTest : public testing::Test {
protected:
    MaterialsOf file{MaterialsOf::fixture("material-textures.dae")};
};

TEST_F(TextureReaderTest, samplerLeadsToSurfaceToImageToPicture) {
    const Material chain = file.material("chain");
    const Texture& texture = file.texture(chain, Slot::Diffuse);

    EXPECT_EQ(texture.id, "skin-img");  // not its smaller copy
    ASSERT_TRUE(texture.image);
    EXPECT_EQ(texture.image->width, 2);
    EXPECT_EQ(texture.image->rgba[0], 255);
    EXPECT_EQ(chain.slot(Slot::Diffuse).color, glm::vec4(1.0f));
    EXPECT_EQ(chain.slot(Slot::Diffuse).texCoordName, "UVSET1");
    EXPECT_EQ(codes(file.diagnostics.all()), (std::vector<std::string>{"WC0603", "WC0120", "WC0120"}))
        << "the guess of the material, its bump in <extra>, and the set that UVSET1 means";
}

TEST_F(TextureReaderTest, samplerSaysHowThePictureIsRepeatedAndFiltered) {
    const Texture& texture = file.texture(file.material("chain"), Slot::Diffuse);

    EXPECT_EQ(texture.wrapS, Wrap::Mirror);
    EXPECT_EQ(texture.wrapT, Wrap::Clamp);
    EXPECT_EQ(texture.minFilter, Filter::Nearest);
    EXPECT_EQ(texture.magFilter, Filter::Nearest);
    EXPECT_EQ(texture.borderColor, glm::vec4(1.0f, 0.5f, 0.0f, 1.0f));
}

TEST_F(TextureReaderTest, oneSamplerIsOneTexture) {
    const Material chain = file.material("chain");

    EXPECT_EQ(chain.slot(Slot::Diffuse).texture, chain.slot(Slot::Transparent).texture);
    EXPECT_EQ(file.model.textures.size(), 2u);  // and the bumps
}

TEST_F(TextureReaderTest, aPictureIsDecodedOnceForAllItsSamplers) {
    const Material chain = file.material("chain");
    const Material direct = file.material("direct");

    EXPECT_NE(chain.slot(Slot::Diffuse).texture, direct.slot(Slot::Diffuse).texture);
    EXPECT_EQ(file.texture(chain, Slot::Diffuse).image, file.texture(direct, Slot::Diffuse).image);
}

TEST_F(TextureReaderTest, aTransparentPictureWithHolesBlends) {
    EXPECT_TRUE(file.material("chain").transparent);
    EXPECT_FALSE(file.material("direct").transparent);
}

TEST_F(TextureReaderTest, bumpsStandInExtra) {
    const Material chain = file.material("chain");

    EXPECT_TRUE(chain.slot(Slot::Bump).present);
    EXPECT_EQ(file.texture(chain, Slot::Bump).image->rgba[3], 255);  // heights are turned into normals
    EXPECT_NE(chain.slot(Slot::Bump).texture, chain.slot(Slot::Diffuse).texture);
    EXPECT_EQ(chain.slot(Slot::Bump).texCoordName, "UVSET0");
}

TEST_F(TextureReaderTest, aTextureMayNameItsImage) {
    EXPECT_TRUE(file.texture(file.material("direct"), Slot::Diffuse).image);
    EXPECT_EQ(file.notes(Code::TextureNamesImage), 1);
}

TEST_F(TextureReaderTest, samplersOf15InstanceTheirImage) {
    const Texture& texture = file.texture(file.material("new"), Slot::Diffuse);

    EXPECT_TRUE(texture.image);
    EXPECT_EQ(texture.minFilter, Filter::LinearMipmapNearest);
}

TEST_F(TextureReaderTest, aMaterialSetsTheSurface) {
    EXPECT_TRUE(file.texture(file.material("set"), Slot::Diffuse).image);
    EXPECT_EQ(file.material("unset").slot(Slot::Diffuse).texture, -1);
    EXPECT_EQ(file.warnings(Code::TextureUnresolved), 1);
}

TEST_F(TextureReaderTest, whatLeadsToNoPictureIsReportedAndStaysVisible) {
    const Material dangling = file.material("dangling");

    EXPECT_EQ(file.warnings(Code::TextureUnresolved), 3);
    EXPECT_FALSE(file.hasErrors());
    EXPECT_EQ(dangling.slot(Slot::Diffuse).color, glm::vec4(1.0f));
    EXPECT_EQ(dangling.slot(Slot::Emission).color, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));  // it must not glow
    EXPECT_FALSE(dangling.transparent);
}

TEST_F(TextureReaderTest, anImageWithoutAPictureIsReported) {
    const Material blank = file.material("blank");

    EXPECT_FALSE(file.texture(blank, Slot::Diffuse).image);
    EXPECT_EQ(file.warnings(Code::ImageEmpty), 1);
}

}  // namespace
}  // namespace walkcycle
