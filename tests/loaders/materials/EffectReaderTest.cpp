#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/MaterialsOf.h"
#include "loaders/materials/EffectReader.h"

namespace walkcycle {
namespace {

class EffectReaderTest : public testing::Test {
protected:
    MaterialsOf file{MaterialsOf::fixture("material-slots.dae")};
};

TEST_F(EffectReaderTest, aSlotHoldsAColourOrAParameter) {
    const Material skin = file.material("skin");

    EXPECT_EQ(skin.name, "Skin");
    EXPECT_EQ(skin.shading, ShadingModel::Phong);
    EXPECT_EQ(skin.slot(Slot::Emission).color, glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
    EXPECT_EQ(skin.slot(Slot::Diffuse).color, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_FLOAT_EQ(skin.shininess, 8.0f);
    EXPECT_FLOAT_EQ(skin.reflectivity, 0.25f);
    EXPECT_FLOAT_EQ(skin.indexOfRefraction, 1.5f);
    EXPECT_FALSE(skin.slot(Slot::Reflective).present);
}

TEST_F(EffectReaderTest, theProfilesParameterHidesTheEffects) {
    EXPECT_EQ(file.material("skin").slot(Slot::Ambient).color, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
}

TEST_F(EffectReaderTest, aMaterialSetsTheParametersOfItsEffect) {
    EXPECT_EQ(file.material("green").slot(Slot::Diffuse).color, glm::vec4(0.0f, 1.0f, 0.0f, 1.0f));
    EXPECT_EQ(file.material("skin").slot(Slot::Diffuse).color, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
}

TEST_F(EffectReaderTest, aParameterThatIsNotThereIsReportedAndLeavesBlack) {
    EXPECT_EQ(file.material("skin").slot(Slot::Specular).color, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(file.warnings(Code::ParameterNotThere), 1);
}

TEST_F(EffectReaderTest, hintsOfExportersMakeItDoubleSided) {
    EXPECT_TRUE(file.material("skin").doubleSided);
    EXPECT_FALSE(file.material("half").doubleSided);
}

TEST_F(EffectReaderTest, aColourOfTooFewNumbersIsReported) {
    EXPECT_EQ(file.material("sketch").slot(Slot::Emission).color, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(file.warnings(Code::ColorNumbers), 1);
}

TEST_F(EffectReaderTest, effectsThatCannotBeShownAreReported) {
    file.material("program");
    file.material("empty");
    EXPECT_EQ(file.warnings(Code::EffectUnusable), 2);
    file.material("lost");
    EXPECT_EQ(file.warnings(Code::EffectNotThere), 1);
    EXPECT_TRUE(file.model.materials.empty());
    EXPECT_FALSE(file.hasErrors());
}

TEST_F(EffectReaderTest, whatIsNotFullyOpaqueIsDrawnWithBlending) {
    EXPECT_FALSE(file.material("skin").transparent);
    EXPECT_TRUE(file.material("half").transparent);
    EXPECT_TRUE(file.material("veil").transparent);
    EXPECT_EQ(file.material("veil").opaque, OpaqueMode::RgbZero);
}

TEST_F(EffectReaderTest, transparencyAloneIsOpacity) {
    const Material glass = file.material("glass");

    EXPECT_TRUE(glass.transparent);
    EXPECT_FLOAT_EQ(opacity(glass, glass.slot(Slot::Transparent).color), 0.4f);
}

TEST_F(EffectReaderTest, aTransparencyOfZeroMeansSolidAsExportersHaveIt) {
    const Material zero = file.material("zero");

    EXPECT_FALSE(zero.transparent);
    EXPECT_FLOAT_EQ(opacity(zero, zero.slot(Slot::Transparent).color), 1.0f);
    EXPECT_EQ(file.notes(Code::TransparencyInverted), 1);
}

TEST_F(EffectReaderTest, anAlphaOfZeroIsInvisibleAsTheFormatHasIt) {
    const Material ghost = file.material("ghost");

    EXPECT_TRUE(ghost.transparent);
    EXPECT_FLOAT_EQ(opacity(ghost, ghost.slot(Slot::Transparent).color), 0.0f);
}

TEST_F(EffectReaderTest, onlyTheTransparencyOfAOneIsEverInverted) {
    LoadOptions options;
    options.quirks["inverted-transparency"] = true;
    MaterialsOf inverted(file.root.file(), options);
    EXPECT_FLOAT_EQ(inverted.material("glass").transparency, 0.6f);
    EXPECT_FLOAT_EQ(inverted.material("veil").transparency, 0.25f);
    EXPECT_FLOAT_EQ(file.material("glass").transparency, 0.4f);
}

TEST_F(EffectReaderTest, anOpaqueWordThatIsNotKnownIsReported) {
    EXPECT_EQ(file.material("odd").opaque, OpaqueMode::AOne);
    EXPECT_EQ(file.warnings(Code::WordUnknown), 1);
}

TEST(EffectReaderValuesTest, aPartOfAShaderThatSaysNothingIsReported) {
    const std::string text = collada(
        "<library_effects><effect id='e'><profile_COMMON><technique sid='t'><phong>\n<diffuse/>\n"
        "<shininess/>\n<transparency><float>1 "
        "2</float></transparency>\n<reflectivity><float/></reflectivity>\n"
        "</phong></technique></profile_COMMON></effect></library_effects>"
        "<library_materials><material id='m'><instance_effect url='#e'/></material></library_materials>" +
        std::string("<library_geometries><geometry id='g'><mesh>") + floatSource("p", "0 0 0 1 0 0 0 1 0") +
        "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles count='1' "
        "material='m'>"
        "<input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2</p></triangles></mesh></geometry>"
        "</library_geometries>" +
        scene("<node><instance_geometry url='#g'/></node>"));
    std::vector<int> lines;
    for (const Diagnostic& said : loadText(text).diagnostics)
        if (said.severity == Severity::Warning) lines.push_back(said.line);
    EXPECT_THAT(lines,
                testing::UnorderedElementsAre(lineOf(text, "<diffuse"), lineOf(text, "<shininess"),
                                              lineOf(text, "<transparency"), lineOf(text, "<reflectivity")));
}

}  // namespace
}  // namespace walkcycle
