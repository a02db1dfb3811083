#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "loaders/LoadText.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/document/MessageTemplate.h"

namespace walkcycle {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(DiagnosticsTest, everyCodeHasANumberOfItsOwnAndSaysCauseAndCure) {
    std::set<std::string> ids;
    for (const CodeInfo& entry : diagnosticCatalogue()) {
        EXPECT_TRUE(ids.insert(entry.id).second) << entry.id << " twice";
        EXPECT_THAT(std::string(entry.id), SizeIs(6));
        EXPECT_NE(std::string(entry.cause), "") << entry.id;
        EXPECT_NE(std::string(entry.cure), "") << entry.id;
        EXPECT_EQ(&info(entry.code), &entry);
    }
}

// A bare {0} would reach the user of `explain`.
TEST(DiagnosticsTest, everyPlaceholderHasAWordForItself) {
    for (const CodeInfo& entry : diagnosticCatalogue())
        for (const std::string text : {entry.text, entry.cure})
            EXPECT_EQ(withWords(text).find_first_of("{}"), std::string::npos) << entry.id << ": " << text;
}

TEST(DiagnosticsTest, placeholdersTakeArgumentsByNumber) {
    const auto brackets = [](std::size_t i, std::string_view word) {
        return "[" + std::to_string(i) + " " + std::string(word) + "]";
    };
    EXPECT_EQ(replacePlaceholders("<{1:CHILD}> in {0:ELEMENT}{2:}", brackets),
              "<[1 CHILD]> in [0 ELEMENT][2 ]");
    EXPECT_EQ(replacePlaceholders("{frame} {} {0} {0:", brackets), "{frame} {} {0} {0:");
    EXPECT_EQ(withWords("<{0:ELEMENT}> is misspelt{1:}"), "<ELEMENT> is misspelt");
}

TEST(DiagnosticsTest, theLibrarySpeaksOfNoCommandLine) {
    for (const CodeInfo& entry : diagnosticCatalogue())
        for (const char* text : {entry.text, entry.cause, entry.cure})
            EXPECT_THAT(text, testing::Not(testing::HasSubstr("--"))) << entry.id;
}

TEST(DiagnosticsTest, aReportSaysFileLineAndElement) {
    TestLoad load("<COLLADA>\n<library_nodes>\n<node id='hip'/></library_nodes></COLLADA>");
    load.diagnostics.report(Code::MissingElement, load.byId("hip"), {"node", "translate"});
    EXPECT_THAT(load.diagnostics.all()[0], says("WC0203", 3, "COLLADA/library_nodes/node[id=hip]"));
    EXPECT_EQ(toString(load.diagnostics.all()[0]).substr(0, 85),
              "test.dae:3: error WC0203: <node> has no <translate>, in library_nodes/node[id=hip] (e");
}

TEST(DiagnosticsTest, whatRepeatsIsCountedAfterTheThird) {
    TestLoad load("<COLLADA><node/></COLLADA>");
    for (int i = 0; i < 1000; ++i)
        load.diagnostics.report(Code::MissingElement, load.collada.child("node"),
                                {"node", std::to_string(i)});
    load.diagnostics.report(Code::MissingElement, load.collada, {"COLLADA", "scene"});
    ASSERT_THAT(load.diagnostics.all(), SizeIs(4));
    EXPECT_EQ(load.diagnostics.all()[2].repeats, 997);
    EXPECT_THAT(toString(load.diagnostics.all()[2]), HasSubstr("[and 997 more like it]"));
}

TEST(DiagnosticsTest, theReasonOfAFailureComesLastAndKnowsItsElement) {
    TestLoad load("<COLLADA>\n<scene/></COLLADA>");
    load.diagnostics.report(Code::MissingElement, load.collada, {"COLLADA", "asset"});
    try {
        load.diagnostics.fail(Code::NoScene, load.collada.child("scene"), {});
        FAIL();
    } catch (const LoadError& error) {
        EXPECT_THAT(codes(error.diagnostics), testing::ElementsAre("WC0203", "WC0701"));
        EXPECT_THAT(error.diagnostics.back(), says("WC0701", 2, "COLLADA/scene"));
        EXPECT_EQ(error.what(), toString(error.diagnostics.back()));
    }
}

TEST(DiagnosticsTest, whatAFileSaysCannotForgeLinesOrTerminalEscapes) {
    Diagnostics diagnostics;
    diagnostics.report(Code::FileUnreadable, "a.dae", 1, {"first\nsecond\x1b[31m\x7f"});
    EXPECT_EQ(diagnostics.all()[0].message, "first second [31m ");
}

TEST(DiagnosticsTest, aHostileIdIsNoEscapeInThePathEither) {
    TestLoad load("<COLLADA><node id='a&#10;b\x1b[2J'/></COLLADA>");
    EXPECT_EQ(load.collada.child("node").path(), "COLLADA/node[id=a b [2J]");
}

TEST(DiagnosticsTest, aVeryLongArgumentIsCutBetweenCharacters) {
    Diagnostics diagnostics;
    diagnostics.report(Code::FileUnreadable, "a.dae", 1, {std::string(199, 'x') + "\xC3\xA9tude"});
    EXPECT_EQ(diagnostics.all()[0].message, std::string(199, 'x') + "...");
    diagnostics.report(Code::FileUnreadable, "b.dae", 1, {std::string(198, 'x') + "\xC3\xA9tude"});
    EXPECT_EQ(diagnostics.all()[1].message, std::string(198, 'x') + "\xC3\xA9...");
}

TEST(DiagnosticsTest, oneFaultInElementsOfManyNamesIsAHandfulOfLines) {
    std::string text = "<COLLADA>";
    for (int i = 0; i < 10000; ++i) text += "<e" + std::to_string(i % 500) + "/>";
    TestLoad load(text + "</COLLADA>");
    for (const XmlNode element : load.collada.children())
        load.diagnostics.report(Code::MissingAttribute, element, {std::string(element.name()), "id"});
    EXPECT_LT(load.diagnostics.all().size(), 20u);
    int counted = 0;
    for (const Diagnostic& one : load.diagnostics.all()) counted += 1 + one.repeats;
    EXPECT_EQ(counted, 10000);
}

TEST(DiagnosticsTest, tenThousandDamagedNodesAreAHandfulOfLines) {
    std::string nodes;
    for (int i = 0; i < 10000; ++i)
        nodes += "<node id='n" + std::to_string(i) + "'><" +
                 (i % 2 ? "translate>1 x 2</translate" : "scale>1 1</scale") +
                 "><instance_geometry url='#gone" + std::to_string(i) + "'/></node>\n";
    const Model model = loadText(collada(scene(nodes)));
    EXPECT_LT(model.diagnostics.size(), 15u);
    EXPECT_EQ(model.skeleton.joints.size(), 10000u);
}

TEST(DiagnosticsTest, aFileOfManyKindsOfFaultsDoesNotFillTheMemory) {
    std::string text = "<COLLADA>";
    for (int i = 0; i < 20000; ++i) text += "<e" + std::to_string(i) + " id='same'/>";
    TestLoad load(text + "</COLLADA>");
    EXPECT_LT(load.diagnostics.all().size(), 5000u);
}

}  // namespace
}  // namespace walkcycle
