#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/CodeCases.h"
#include "loaders/LoadText.h"

namespace walkcycle {
namespace {

bool operator==(const Exporter& a, const Exporter& b) {
    return a.tool == b.tool && a.version == b.version;
}

Exporter exporter(Tool tool, int major, int minor) {
    return {tool, ToolVersion{major, minor}};
}

TEST(DialectTest, theExporterIsNamedByTheAuthoringTool) {
    const std::pair<const char*, Exporter> kCases[] = {
        {"Maya 7.0 | ColladaMaya v2.03b Jul 27 2006 at 18:43:34 | FCollada v1.13",
         exporter(Tool::ColladaMaya, 2, 3)},
        {"Maya8.5 | ColladaMaya v3.04_FREE r6492", exporter(Tool::ColladaMaya, 3, 4)},
        {"ColladaMaya", {Tool::ColladaMaya, {}}},
        {"3dsMax 10 - Feeling ColladaMax v3.05B.", exporter(Tool::ColladaMax, 3, 5)},
        {"3dsMax 8 - Feeling ColladaMax 0.4", exporter(Tool::ColladaMax, 0, 4)},
        {"FCollada v3.05B", exporter(Tool::FCollada, 3, 5)},
        {"OpenCOLLADA2011", exporter(Tool::OpenCollada, 2011, 0)},
        {"OpenCOLLADA for 3ds Max; Version: 1.2", {Tool::OpenCollada, {}}},
        {"Autodesk Softimage version 8.0.200.0 - Crosswalk 4.1", exporter(Tool::Softimage, 8, 0)},
        {"Softimage Softimage version 7.5.191.0 - Crosswalk 4.0", exporter(Tool::Softimage, 7, 5)},
        {"FBX COLLADA exporter", {Tool::FbxCollada, {}}},
        {"COLLADA Mixamo exporter", {Tool::Mixamo, {}}},
        {"SceneKit Collada Exporter v1.0", exporter(Tool::SceneKit, 1, 0)},
        {"Google SketchUp 8.0.4811", exporter(Tool::SketchUp, 8, 0)},
        {"SketchUp 15.3.331", exporter(Tool::SketchUp, 15, 3)},
        {"Blender 2.76.0 commit date:2015-11-03, commit time:10:56", exporter(Tool::Blender, 2, 76)},
        {"BLENDER 3.4.1", exporter(Tool::Blender, 3, 4)},
        {"Blender 99999999999.1", {Tool::Blender, {}}},
        {"Blender 2.", exporter(Tool::Blender, 2, 0)},
        {"by hand", {}},
        {"", {}}};
    for (const auto& [text, expected] : kCases) EXPECT_TRUE(exporterOf(text) == expected) << text;
}

// The ranges that tangents of one number will need.
TEST(DialectTest, aRangeOfVersionsEndsBeforeItsLast) {
    constexpr ToolRange kOldMaya{Tool::ColladaMaya, {1, 0}, {3, 0}}, kOldMax{Tool::ColladaMax, {}, {1, 0}};
    EXPECT_TRUE(isIn(exporterOf("Maya 7.0 | ColladaMaya v2.03b | FCollada v1.13"), kOldMaya));
    EXPECT_TRUE(isIn(exporterOf("ColladaMaya v1.0"), kOldMaya));
    EXPECT_FALSE(isIn(exporterOf("ColladaMaya v0.9"), kOldMaya));
    EXPECT_FALSE(isIn(exporterOf("Maya 8.0 | ColladaMaya v3.00 | FCollada v3.0"), kOldMaya));
    EXPECT_TRUE(isIn(exporterOf("3dsMax 8 - Feeling ColladaMax 0.4"), kOldMax));
    EXPECT_FALSE(isIn(exporterOf("3dsMax 8 - Feeling ColladaMax v3.04C"), kOldMax));
    EXPECT_FALSE(isIn(exporterOf("ColladaMax"), kOldMax)) << "of no version";
    EXPECT_FALSE(isIn(exporterOf("by hand"), ToolRange{})) << "no tool is in no range";
}

bool follows(Quirk quirk, const std::string& tool, const LoadOptions& options = {}) {
    return Dialect(tool, options).follows(quirk);
}

TEST(DialectTest, theToolDecidesWhetherTheNodePlacesASkinUnlessTheUserDoes) {
    EXPECT_TRUE(follows(Quirk::SkinByNode, "Maya 8.5 | ColladaMaya v3.03b"));
    EXPECT_TRUE(follows(Quirk::SkinByNode, "Autodesk Softimage, Crosswalk"));
    LoadOptions apply, ignore, both;
    apply.skinNode = both.skinNode = SkinNode::Apply;
    ignore.skinNode = SkinNode::Ignore;
    both.quirks["skin-by-node"] = false;
    for (const char* tool : {"", "Blender 3.4.1", "OpenCOLLADA for 3ds Max", "FBX COLLADA exporter",
                             "SceneKit Collada Exporter"}) {
        EXPECT_FALSE(follows(Quirk::SkinByNode, tool)) << tool;
        EXPECT_TRUE(follows(Quirk::SkinByNode, tool, apply)) << tool;
    }
    EXPECT_FALSE(follows(Quirk::SkinByNode, "ColladaMaya", ignore));
    EXPECT_FALSE(follows(Quirk::SkinByNode, "ColladaMaya", both)) << "a quirk by name goes before skinNode";
}

TEST(DialectTest, onlyEarlyVersionsOfSketchUpInvertTransparency) {
    EXPECT_TRUE(follows(Quirk::InvertedTransparency, "Google SketchUp 6.4.112"));
    EXPECT_TRUE(follows(Quirk::InvertedTransparency, "Google SketchUp 7"));
    EXPECT_TRUE(follows(Quirk::InvertedTransparency, "Google SketchUp 7.0.10247"));
    for (const char* tool : {"Google SketchUp 7.1.4871", "Google SketchUp 8.0", "Google SketchUp", "by hand"})
        EXPECT_FALSE(follows(Quirk::InvertedTransparency, tool)) << tool;
}

TEST(DialectTest, whyAQuirkIsOnOrOff) {
    LoadOptions options;
    options.quirks["spaced-names"] = false;
    const Dialect dialect("ColladaMaya", options);
    EXPECT_EQ(dialect.why(Quirk::SkinByNode), "for ColladaMaya, Softimage");
    EXPECT_EQ(dialect.why(Quirk::InvertedTransparency), "only for SketchUp before 7.1");
    EXPECT_EQ(dialect.why(Quirk::ZeroTransparency), "where the file shows it");
    EXPECT_EQ(dialect.why(Quirk::SpacedNames), "as chosen");
}

std::string by(const std::string& tool, const std::string& more = "") {
    return "<COLLADA><asset><contributor><author>me</author></contributor><contributor><authoring_tool>" +
           tool + "</authoring_tool></contributor></asset>" + more + "</COLLADA>";
}

TEST(DialectTest, eachDocumentHasItsOwn) {
    LoadOptions options;
    options.resolver = files({{"other.dae", by("ColladaMaya v3.02", "<node id='n'/>")}});
    TestLoad load(by("Blender 3.4.1"), options);
    const XmlNode other = load.documents.resolve(load.collada, "other.dae#n");
    ASSERT_TRUE(other);
    EXPECT_EQ(load.dialects.of(load.collada).exporter().tool, Tool::Blender);
    EXPECT_EQ(load.dialects.of(other).exporter().tool, Tool::ColladaMaya);
    EXPECT_FALSE(load.dialects.follows(Quirk::SkinByNode, load.collada));
    EXPECT_TRUE(load.dialects.follows(Quirk::SkinByNode, other));
}

TEST(DialectTest, whatIsNotedIsSaidOncePerDocument) {
    TestLoad load(by("", "<node id='n'/>"));
    EXPECT_FALSE(load.dialects.of(load.collada).isUsed(Quirk::ExtraVisibility));
    load.dialects.note(Quirk::ExtraVisibility, load.byId("n"));
    load.dialects.note(Quirk::ExtraVisibility, load.collada);
    load.dialects.note(Quirk::SkinByNode, load.collada);  // has a code of its own
    EXPECT_EQ(codes(load.diagnostics.all()), std::vector<std::string>{"WC0120"});
    EXPECT_TRUE(load.dialects.of(load.collada).isUsed(Quirk::ExtraVisibility));
    EXPECT_TRUE(load.dialects.of(load.collada).isUsed(Quirk::SkinByNode));
}

}  // namespace
}  // namespace walkcycle
