#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/PaintedText.h"
#include "loaders/TestFiles.h"
#include "loaders/materials/EffectReader.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Material materialOf(const PaintedText& painted, const LoadOptions& options = {}) {
    const Model model = loadText(painted.text(), options);
    return model.materials.empty() ? Material() : model.materials[0];
}

std::string bump(const std::string& inside) {
    return "<extra><technique profile='FCOLLADA'>" + inside + "</technique></extra>";
}

const std::string kTransparent = "<transparent opaque='";

TEST(EffectPicturesTest, aPictureThatIsNotThereHidesNothing) {
    const Material ambient = materialOf({.shader = "<ambient><texture texture='gone'/></ambient>"});
    EXPECT_EQ(ambient.slot(Slot::Ambient).color, glm::vec4(1.0f));
    const Material veil =
        materialOf({.shader = kTransparent + "A_ZERO'><texture texture='gone'/></transparent>"});
    EXPECT_EQ(veil.opaque, OpaqueMode::AZero);
    EXPECT_FALSE(veil.transparent);
}

TEST(EffectPicturesTest, aTransparentPictureBlendsWhereItsAlphaOrItsColoursSaySo) {
    struct Case {
        const char *opaque, *picture, *rest;
        bool transparent;
    };
    for (const Case& c : {Case{"A_ONE", "solid", "", false}, Case{"A_ONE", "picture", "", true},
                          Case{"A_ZERO", "solid", "", false}, Case{"RGB_ONE", "solid", "", true},
                          Case{"RGB_ZERO", "solid", "", true},
                          Case{"A_ONE", "solid", "<transparency><float>0.5</float></transparency>", true}}) {
        const std::string shader =
            kTransparent + c.opaque + "'><texture texture='" + c.picture + "'/></transparent>";
        EXPECT_EQ(materialOf({.shader = shader + c.rest}).transparent, c.transparent) << shader << c.rest;
    }
    EXPECT_EQ(materialOf({.shader = kTransparent + "RGB_ONE'><color>1 1 1 1</color></transparent>"}).opaque,
              OpaqueMode::RgbOne);
}

TEST(EffectPicturesTest, doubleSidedIsSaidInThreeWays) {
    for (const char* yes : {"1", "true", "TRUE"})
        EXPECT_TRUE(
            materialOf({.extra = bump("<double_sided>" + std::string(yes) + "</double_sided>")}).doubleSided);
    EXPECT_FALSE(materialOf({.extra = bump("<double_sided>0</double_sided>")}).doubleSided);
}

TEST(EffectPicturesTest, aProfileWithoutATechniqueIsReportedWhereItStands) {
    std::string text = PaintedText().text();
    const std::size_t from = text.find("<technique sid"), to = text.find("</profile_COMMON>");
    text.erase(from, to - from);
    const std::vector<Diagnostic> said = PaintedText::warnings(loadText(text));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].code, "WC0605");
    EXPECT_EQ(said[0].line, lineOf(text, "<profile_COMMON"));
}

TEST(EffectPicturesTest, ofAColourWithFiveNumbersFourCountAndItIsReported) {
    const PaintedText painted{.shader = "<diffuse><color>0.1 0.2 0.3 0.4 0.5</color></diffuse>"};
    const Model model = loadText(painted.text());
    EXPECT_THAT(codes(PaintedText::warnings(model)), ElementsAre("WC0607"));
    EXPECT_EQ(model.materials.at(0).slot(Slot::Diffuse).color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
}

TEST(EffectPicturesTest, aNumberThatRefersToNoParameterIsReportedOnce) {
    const PaintedText painted{.shader = "<shininess><param ref='none'/></shininess>"};
    EXPECT_THAT(codes(PaintedText::warnings(loadText(painted.text()))), ElementsAre("WC0606"));
}

TEST(EffectPicturesTest, aParameterMaySayOtherThingsBeforeItsValueOrHaveNone) {
    const std::string value =
        "<newparam sid='c'><annotate/><semantic>DIFFUSE</semantic><modifier>CONST</modifier>"
        "<float4>1 0 0 1</float4></newparam>";
    const std::string shader = "<diffuse><param ref='c'/></diffuse>";
    EXPECT_EQ(materialOf({.shader = shader, .params = value}).slot(Slot::Diffuse).color,
              glm::vec4(1, 0, 0, 1));
    const PaintedText empty{.shader = shader,
                            .params = "<newparam sid='c'><semantic>DIFFUSE</semantic></newparam>"};
    EXPECT_THAT(codes(PaintedText::warnings(loadText(empty.text()))), ElementsAre("WC0606"));
}

// The user's picture replaces the diffuse pictures; only where there are none, it goes on everything.
TEST(EffectPicturesTest, theChosenPictureGoesWhereDiffusePicturesAreOrOnEverything) {
    const TestFolder folder;
    LoadOptions options;
    const Bytes png = encodePng({.width = 1, .height = 1, .hasAlpha = false, .rgba = {7, 7, 7, 255}});
    options.texture = folder.write("mine.png", std::string(png.begin(), png.end()));
    const PaintedText colour{.shader = "<diffuse><color>1 0 0 1</color></diffuse>"};
    const Model all = loadText(colour.text(), options);
    ASSERT_EQ(all.materials.at(0).slot(Slot::Diffuse).texture, 0);
    EXPECT_EQ(all.textures.at(0).image->rgba[0], 7);
    EXPECT_EQ(all.materials[0].slot(Slot::Diffuse).color, glm::vec4(1.0f));

    const PaintedText gone{.shader = "<diffuse><texture texture='gone'/></diffuse>"};
    const Model replaced = loadText(gone.text(), options);
    EXPECT_EQ(replaced.textures.at(0).image->rgba[0], 7);

    std::string other = colour.text();
    const std::string fx =
        "<effect id='f'><profile_COMMON><technique><phong><diffuse><texture "
        "texture='solid'/></diffuse></phong>"
        "</technique></profile_COMMON></effect>";
    other.insert(other.find("<effect id='e'"), fx);
    EXPECT_EQ(materialOf(colour, options).slot(Slot::Diffuse).color, glm::vec4(1.0f));
    const Model kept = loadText(other, options);
    EXPECT_EQ(kept.materials.at(0).slot(Slot::Diffuse).texture, -1);
    EXPECT_EQ(kept.materials[0].slot(Slot::Diffuse).color, glm::vec4(1, 0, 0, 1));

    options.texture = folder.write("mine.txt", "no picture");
    const Model broken = loadText(colour.text(), options);
    EXPECT_EQ(broken.materials.at(0).slot(Slot::Diffuse).color, glm::vec4(1, 0, 0, 1));
    ASSERT_THAT(codes(PaintedText::warnings(broken)), ElementsAre("WC0622"));
    EXPECT_THAT(PaintedText::warnings(broken)[0].file, HasSubstr("mine.txt"));
}

TEST(EffectPicturesTest, bumpsAreHeightsWhereTheySaySoOrAreGrey) {
    struct Case {
        const char *kind, *picture;
        bool converted;
    };
    for (const Case& c :
         {Case{"", "grey", true}, Case{"", "solid", false}, Case{"bumptype='NORMALMAP'", "grey", false},
          Case{"bumptype='HEIGHTFIELD'", "solid", true}}) {
        const std::string element =
            "<bump " + std::string(c.kind) + "><texture texture='" + c.picture + "'/></bump>";
        const Model model = loadText(PaintedText{.extra = bump(element)}.text());
        const int texture = model.materials.at(0).slot(Slot::Bump).texture;
        EXPECT_EQ(texture, c.converted ? 1 : 0) << element;
        if (c.converted) {
            EXPECT_GT(model.textures.at(1).image->rgba[2], 128) << "normals point out of the surface";
        }
    }
}

TEST(EffectPicturesTest, ofSeveralBumpsTheFirstWithAPictureElementCounts) {
    const Material first =
        materialOf({.extra = bump("<bump/>") + bump("<bump><texture texture='grey'/></bump>") +
                             bump("<bump><texture texture='solid'/></bump>")});
    EXPECT_EQ(first.slot(Slot::Bump).texture, 1);
    const Model gone = loadText(PaintedText{.extra = bump("<bump><texture texture='gone'/></bump>")}.text());
    EXPECT_THAT(codes(PaintedText::warnings(gone)), ElementsAre("WC0608"));
    EXPECT_EQ(gone.materials.at(0).slot(Slot::Bump).texture, -1);
}

TEST(EffectPicturesTest, materialsOfOneEffectAreAlikeUnlessTheySetSomething) {
    PaintedText painted{.shader = "<diffuse><param ref='c'/></diffuse>",
                        .params = "<newparam sid='c'><float4>1 0 0 1</float4></newparam>",
                        .extra = bump("<bump bumptype='HEIGHTFIELD'><texture texture='grey'/></bump>")};
    const std::string green = "<setparam ref='c'><float4>0 1 0 1</float4></setparam>";
    const std::string blue = "<setparam ref='c'><float4>0 0 1 1</float4></setparam>";
    painted.materials = "";
    for (const auto& [id, own] : {std::pair("m", std::string()), std::pair("n", std::string()),
                                  std::pair("g", green), std::pair("b", blue)})
        painted.materials += "<material id='" + std::string(id) + "'><instance_effect url='#e'>" + own +
                             "</instance_effect></material>";
    std::string text = painted.text(), triangles;
    for (const char* id : {"n", "g", "b"})
        triangles += "<triangles material='" + std::string(id) +
                     "' count='1'><input semantic='VERTEX' source='#mesh-vertices' offset='0'/><p>0 1 "
                     "2</p></triangles>";
    text.insert(text.find("</mesh>"), triangles);
    const Model model = loadText(text);
    ASSERT_EQ(model.materials.size(), 4u);
    const std::vector<glm::vec3> expected{{1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(glm::vec3(model.materials[i].slot(Slot::Diffuse).color), expected[i]) << i;
    EXPECT_EQ(model.textures.size(), 2u) << "one picture and its normals, for all of them";
}

TEST(EffectPicturesTest, aMaterialWithoutAnEffectIsReportedWhereItStands) {
    const PaintedText painted{.materials = "\n<material id='m'/>"};
    const std::vector<Diagnostic> said = PaintedText::warnings(loadText(painted.text()));
    ASSERT_THAT(codes(said), ElementsAre("WC0604"));
    EXPECT_EQ(said[0].line, lineOf(painted.text(), "<material id"));
}

TEST(EffectPicturesTest, onlySketchUpBefore71WritesTransparencyTheOtherWayRound) {
    struct Case {
        const char* version;
        float expected;
    };
    for (const Case& c : {Case{"6.4.112", 0.75f}, Case{"7.0.8657", 0.75f}, Case{"7", 0.75f},
                          Case{"7.1.6860", 0.25f}, Case{"Pro", 0.25f}}) {
        std::string text = PaintedText{.shader = "<transparency><float>0.25</float></transparency>"}.text();
        text.insert(text.find("<asset>") + 7, "<contributor><authoring_tool>Google SketchUp " +
                                                  std::string(c.version) + "</authoring_tool></contributor>");
        EXPECT_EQ(loadText(text).materials.at(0).transparency, c.expected) << c.version;
    }
}

}  // namespace
}  // namespace walkcycle
