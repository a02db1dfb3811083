#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "QuirksPage.h"
#include "SourceTree.h"
#include "loaders/quirks/Quirks.h"

using namespace walkcycle::house;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

namespace {

// Where exporters are told apart: nothing else in src/loaders may name one.
bool isOfQuirks(const std::string& file) {
    return file.starts_with("src/loaders/quirks/");
}

// "file:line: Maya" for each exporter that a source names, in code or in a comment. (The catalogue's cures say where to
// click in which program; they are in a .inc.)
std::vector<std::string> exportersNamedIn(const std::string& file, const std::string& text) {
    std::string names =
        "Maya|3ds ?Max|3D Max|Assimp|Autodesk|Cinema "
        "4D|Crosswalk|Google|Houdini|Lightwave|MAX3D|PhyreEngine|Trimble|XSI";
    for (const walkcycle::ToolInfo& tool : walkcycle::kTools) names += "|" + std::string(tool.name);
    names += "|FBX|Mixamo";  // whatever stands around them
    const std::regex exporter("\\b(" + names + ")\\b", std::regex::icase);
    std::vector<std::string> found;
    int number = 0;
    for (const std::string& line : splitLines(text)) {
        ++number;
        std::smatch match;
        if (std::regex_search(line, match, exporter))
            found.push_back(file + ":" + std::to_string(number) + ": " + match.str());
    }
    return found;
}

}  // namespace

TEST(QuirksTest, onlyTheQuirksNameExporters) {
    const auto files = filesBelow("src/loaders", {".h", ".cpp"});
    ASSERT_THAT(files, Not(IsEmpty()));
    for (const std::string& file : files) {
        if (isOfQuirks(file)) continue;
        EXPECT_THAT(exportersNamedIn(file, readText(root() / file)), IsEmpty())
            << "move the rule to src/loaders/quirks/Quirks.h and ask Dialects::follows()";
    }
}

TEST(QuirksTest, anExporterThatIsNamedIsFound) {
    EXPECT_THAT(exportersNamedIn("A.cpp", "int a;\nif (tool == \"COLLADAMaya\") b();\n// 3ds Max does\n"),
                ElementsAre("A.cpp:2: COLLADAMaya", "A.cpp:3: 3ds Max"));
    EXPECT_THAT(exportersNamedIn("A.h", "const char* inMaya = \"\";  // the maximum\n"), IsEmpty());
}

TEST(QuirksTest, theNotesListTheQuirksAsTheTableHasThem) {
    const auto file = root() / "docs/collada-notes.md";
    const std::string page = readText(file);
    if (updatesDocs()) writeText(file, withQuirksSection(page));
    EXPECT_EQ(readText(file), withQuirksSection(page)) << "run the tests with UPDATE_DOCS=1";
    EXPECT_NE(readText(file).find(quirksSection()), std::string::npos);
}

TEST(QuirksTest, eachQuirkHasItsFixture) {
    for (const walkcycle::QuirkInfo& quirk : walkcycle::kQuirks)
        EXPECT_TRUE(
            std::filesystem::exists(root() / "tests/fixtures/quirks" / (std::string(quirk.name) + ".dae")))
            << quirk.name;
}
