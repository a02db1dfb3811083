#include <optional>
#include <string>

#include "loaders/LoadText.h"
#include "loaders/context/AssetReader.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string withAsset(const std::string& asset) {
    return "<COLLADA version='1.4.1'>\n<asset>" + asset + "</asset></COLLADA>";
}

glm::dvec3 converted(double meters, UpAxis axis, const glm::dvec3& point) {
    return glm::dvec3(toMetresYUp(meters, axis) * glm::dvec4(point, 1.0));
}

TEST(AssetReaderTest, anAssetSaysUnitAxisAndTool) {
    TestLoad load(
        withAsset("<contributor><authoring_tool>Blender 3.4</authoring_tool></contributor>"
                  "<unit name='inch' meter='0.0254'/><up_axis> Z_UP\n</up_axis>"));
    const Asset asset = readAsset(load.collada, load.context);
    EXPECT_EQ(asset.version, "1.4.1");
    EXPECT_EQ(asset.authoringTool, "Blender 3.4");
    EXPECT_EQ(asset.unitName, "inch");
    EXPECT_DOUBLE_EQ(asset.metersPerUnit, 0.0254);
    EXPECT_EQ(asset.upAxis, UpAxis::Z);
    EXPECT_THAT(load.diagnostics.all(), IsEmpty());
}

TEST(AssetReaderTest, withoutOneItIsMetresAndYUp) {
    for (const char* text :
         {"<COLLADA/>", "<COLLADA><asset/></COLLADA>", "<COLLADA><asset><unit/></asset></COLLADA>"}) {
        TestLoad load(text);
        const Asset asset = readAsset(load.collada, load.context);
        EXPECT_EQ(asset.metersPerUnit, 1.0);
        EXPECT_EQ(asset.upAxis, UpAxis::Y);
        EXPECT_THAT(load.diagnostics.all(), IsEmpty()) << text;
    }
}

TEST(AssetReaderTest, aUnitOrAxisThatCannotBeUsedIsReportedAndTheDefaultTaken) {
    for (const char* meter : {"0", "-1", "NaN", "INF", "1,0", "", "1e13", "1e300"}) {
        TestLoad load(withAsset("\n<unit meter='" + std::string(meter) + "'/>"));
        EXPECT_EQ(readAsset(load.collada, load.context).metersPerUnit, 1.0);
        EXPECT_THAT(load.diagnostics.all(), ElementsAre(says("WC0110", 3, "COLLADA/asset/unit"))) << meter;
    }
    TestLoad load(withAsset("<up_axis>W_UP</up_axis>"));
    EXPECT_EQ(readAsset(load.collada, load.context).upAxis, UpAxis::Y);
    EXPECT_THAT(load.diagnostics.all(), ElementsAre(says("WC0110", 2, "COLLADA/asset/up_axis")));
}

TEST(AssetReaderTest, theOptionsSpeakInsteadOfTheDocument) {
    LoadOptions options;
    options.upAxis = UpAxis::X;
    options.metersPerUnit = 0.01;
    TestLoad load(withAsset("<unit meter='2'/><up_axis>Z_UP</up_axis>"), options);
    const Asset asset = readAsset(load.collada, load.context);
    EXPECT_EQ(asset.upAxis, UpAxis::X);
    EXPECT_EQ(asset.metersPerUnit, 0.01);
}

TEST(AssetReaderTest, theThreeAxesTurnToYUp) {
    EXPECT_EQ(converted(1, UpAxis::Y, {1, 2, 3}), glm::dvec3(1, 2, 3));
    EXPECT_EQ(converted(1, UpAxis::Z, {1, 2, 3}), glm::dvec3(1, 3, -2));
    EXPECT_EQ(converted(1, UpAxis::X, {1, 2, 3}), glm::dvec3(-2, 1, 3));
    EXPECT_EQ(converted(0.5, UpAxis::Z, {2, 4, 6}), glm::dvec3(1, 3, -2));
}

TEST(AssetReaderTest, anElementsOwnAssetConvertsIntoTheDocumentsSpace) {
    TestLoad load(
        "<COLLADA><asset><unit meter='1'/><up_axis>Y_UP</up_axis></asset><node id='plain'/>"
        "<node id='inner'><asset><unit meter='0.01'/><up_axis>Z_UP</up_axis></asset><node id='child'/></node>"
        "<node id='unit'><asset><unit meter='2'/></asset></node></COLLADA>");
    const Asset asset = readAsset(load.collada, load.context);
    const auto point = [&](const char* id, XmlNode around) {
        return glm::dvec3(assetConversion(load.byId(id), around, asset, load.collada) *
                          glm::dvec4(100, 200, 300, 1));
    };
    EXPECT_EQ(point("plain", load.collada), glm::dvec3(100, 200, 300));
    EXPECT_LT(glm::length(point("inner", load.collada) - glm::dvec3(1, 3, -2)), 1e-12);
    EXPECT_LT(glm::length(point("child", load.collada) - glm::dvec3(1, 3, -2)), 1e-12);
    EXPECT_EQ(point("child", load.byId("inner")), glm::dvec3(100, 200, 300));
    EXPECT_EQ(point("unit", load.collada), glm::dvec3(200, 400, 600));
}

TEST(AssetReaderTest, anotherDocumentBringsItsOwnUnitAndAxis) {
    LoadOptions options;
    options.resolver = [](const std::string&) {
        return std::optional(bytesOf(
            "<COLLADA><asset><unit meter='0.01'/><up_axis>Z_UP</up_axis></asset><node id='n'/></COLLADA>"));
    };
    TestLoad load("<COLLADA/>", options);
    const Asset asset = readAsset(load.collada, load.context);
    const XmlNode other = load.documents.resolve(load.collada, "b.dae#n");
    const glm::dvec4 point =
        assetConversion(other, load.collada, asset, load.collada) * glm::dvec4(100, 200, 300, 1);
    EXPECT_LT(glm::length(glm::dvec3(point) - glm::dvec3(1, 3, -2)), 1e-12);
}

}  // namespace
}  // namespace walkcycle
