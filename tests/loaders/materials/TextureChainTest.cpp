#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/PaintedText.h"
#include "loaders/materials/TextureReader.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A diffuse picture by a sampler and its surface.
PaintedText sampled(const std::string& sampler,
                    const std::string& surface = "<init_from>picture</init_from>") {
    return {.shader = "<diffuse><texture texture='samp' texcoord='UV'/></diffuse>",
            .params = "<newparam sid='surf'><surface type='2D'>" + surface +
                      "</surface></newparam>\n<newparam sid='samp'><sampler2D>" + sampler +
                      "</sampler2D></newparam>"};
}

std::string pictureOf(const PaintedText& painted) {
    const Model model = loadText(painted.text());
    EXPECT_THAT(PaintedText::warnings(model), IsEmpty());
    const Texture& texture = model.textures.at(0);
    EXPECT_TRUE(texture.image);
    return texture.id;
}

// Why there is no picture.
std::string reasonOf(const PaintedText& painted) {
    const std::string text = painted.text();
    const std::vector<Diagnostic> said = PaintedText::warnings(loadText(text));
    EXPECT_THAT(codes(said), ElementsAre("WC0608"));
    EXPECT_EQ(said.at(0).line, lineOf(text, "<texture "));
    return said.at(0).message;
}

TEST(TextureChainTest, aWordThatASamplerDoesNotKnowIsReportedWhereItStands) {
    const std::string text = sampled("<source>surf</source>\n<wrap_s>MIRRORED</wrap_s>").text();
    const Model model = loadText(text);
    const std::vector<Diagnostic> said = PaintedText::warnings(model);
    ASSERT_THAT(codes(said), ElementsAre("WC0610"));
    EXPECT_EQ(said[0].line, lineOf(text, "<wrap_s>"));
    EXPECT_THAT(said[0].message, HasSubstr("MIRROR"));
    EXPECT_EQ(model.textures.at(0).wrapS, Wrap::Repeat);
}

TEST(TextureChainTest, mipfiltersOf15AreMixedWithTheFilter) {
    struct Case {
        const char *filter, *mip;
        Filter expected;
    };
    for (const Case& c :
         {Case{"NEAREST", "LINEAR", Filter::NearestMipmapLinear},
          Case{"LINEAR", "LINEAR", Filter::LinearMipmapLinear},
          Case{"NEAREST", "NEAREST", Filter::NearestMipmapNearest},
          Case{"LINEAR", "NEAREST", Filter::LinearMipmapNearest}, Case{"LINEAR", "NONE", Filter::Linear}}) {
        const Model model = loadText(sampled("<source>surf</source><minfilter>" + std::string(c.filter) +
                                             "</minfilter><mipfilter>" + c.mip + "</mipfilter>")
                                         .text());
        EXPECT_EQ(model.textures.at(0).minFilter, c.expected) << c.filter << " " << c.mip;
    }
}

TEST(TextureChainTest, ofABorderColourFourNumbersCount) {
    const Model model =
        loadText(sampled("<source>surf</source><border_color>0.1 0.2 0.3 0.4 0.5</border_color>").text());
    EXPECT_EQ(model.textures.at(0).borderColor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
}

TEST(TextureChainTest, thePictureItselfIsMeantNotItsCopiesOrSlices) {
    EXPECT_EQ(
        pictureOf(sampled("<source>surf</source>",
                          "<init_from mip='0' slice='1'>grey</init_from><init_from mip='1'>grey</init_from>"
                          "<init_from mip='0' slice='0'>solid</init_from>")),
        "solid");
    EXPECT_EQ(pictureOf(sampled("<source>surf</source>", "<init_from mip='1'>grey</init_from>")), "grey");
}

TEST(TextureChainTest, whatExportersLeaveOutOfTheChainIsTakenAsItIsMeant) {
    PaintedText surface = sampled("<source>surf</source>");
    surface.shader = "<diffuse><texture texture='surf'/></diffuse>";
    EXPECT_EQ(pictureOf(surface), "picture");
    EXPECT_EQ(pictureOf(sampled("<source>solid</source>")), "solid");  // the sampler names the image
    EXPECT_EQ(pictureOf(sampled("<source>surf</source>", "<init_from>#solid</init_from>")), "solid");
    EXPECT_EQ(pictureOf(sampled("<source>surf</source>", "<init_from>Named</init_from>")), "picture");
    EXPECT_EQ(pictureOf(sampled("<source>surf</source>", "<init_planar><all ref='grey'/></init_planar>")),
              "grey");
}

TEST(TextureChainTest, whereTheChainBreaksIsSaid) {
    EXPECT_THAT(reasonOf(sampled("<source>none</source>")),
                HasSubstr("its sampler's surface 'none' is not there"));
    EXPECT_THAT(reasonOf(sampled("<source>surf</source>", "")), HasSubstr("its surface names no image"));
    EXPECT_THAT(reasonOf(sampled("<source>surf</source>", "<init_from>none</init_from>")),
                HasSubstr("there is no image 'none'"));
    EXPECT_THAT(reasonOf(sampled("<instance_image url='#e'/>")), HasSubstr("there is no image '#e'"));
    EXPECT_THAT(reasonOf({.shader = "<diffuse><texture texcoord='UV'/></diffuse>"}),
                HasSubstr("'' of the effect"));
}

TEST(TextureChainTest, imagesOf15HoldTheirPictureOneStepFurtherIn) {
    const std::string hex = "<hex format='PNG'>" + PaintedText::pictureHex() + "</hex>";
    for (const std::string& inside :
         {"<init_from>" + hex + "</init_from>",
          "<create_2d><size_exact/><init_from>" + hex + "</init_from></create_2d>",
          "<create_cube><init_from>" + hex + "</init_from></create_cube>"}) {
        PaintedText painted = sampled("<instance_image url='#new'/>");
        painted.images = "<image id='new'>" + inside + "</image>";
        EXPECT_EQ(pictureOf(painted), "new") << inside;
    }
    PaintedText ref = sampled("<instance_image url='#new'/>");
    ref.images = "<image id='new'><init_from>\n<ref>skin.png</ref></init_from></image>";
    const std::string text = ref.text();
    const std::vector<Diagnostic> said = PaintedText::warnings(loadText(text));
    ASSERT_THAT(codes(said), ElementsAre("WC0620"));
    EXPECT_EQ(said[0].line, lineOf(text, "<ref>"));
    EXPECT_THAT(said[0].message, HasSubstr("'skin.png'"));
}

TEST(TextureChainTest, anImageThatSaysNothingIsReportedWhereItStands) {
    PaintedText painted = sampled("<instance_image url='#new'/>");
    painted.images = "\n<image id='new'/>\n";
    const std::vector<Diagnostic> said = PaintedText::warnings(loadText(painted.text()));
    ASSERT_THAT(codes(said), ElementsAre("WC0625"));
    EXPECT_EQ(said[0].line, lineOf(painted.text(), "<image id='new'"));
}

TEST(TextureChainTest, hexadecimalDigitsAreReadInUpperAndLowerCase) {
    std::string upper = PaintedText::pictureHex();
    for (char& c : upper) c = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
    PaintedText painted = sampled("<instance_image url='#new'/>");
    painted.images = "<image id='new'><data>\n" + upper.insert(100, "\n\t [g] ") + "\n</data></image>";
    EXPECT_EQ(pictureOf(painted), "new");
}

}  // namespace
}  // namespace walkcycle
