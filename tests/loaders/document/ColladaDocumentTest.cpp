#include <cstddef>
#include <string>
#include <string_view>

#include "loaders/LoadText.h"
#include "loaders/document/ColladaDocument.h"

namespace walkcycle {
namespace {

using ::testing::HasSubstr;

// Why the bytes are no document, or an empty diagnostic.
Diagnostic refusal(std::string_view bytes, const LoadLimits& limits = {}) {
    Diagnostics diagnostics;
    try {
        ColladaDocument(bytesOf(bytes), "test.dae", limits, diagnostics);
    } catch (const LoadError& error) {
        return error.diagnostics.back();
    }
    return {};
}

std::string nested(int levels) {
    std::string text = "<COLLADA>\n";  // is one of them
    for (int i = 1; i < levels; ++i) text += "<node>\n";
    for (int i = 1; i < levels; ++i) text += "</node>";
    return text + "</COLLADA>";
}

TEST(ColladaDocumentTest, anIdMayHoldDotsAndDashesAndSpaces) {
    TestLoad load("<COLLADA><node id='Bip01-L.Thigh'/><node id='left leg'/></COLLADA>");
    EXPECT_TRUE(load.byId("Bip01-L.Thigh"));
    EXPECT_TRUE(load.byId("left leg"));
    EXPECT_FALSE(load.byId("bip01-l.thigh"));
    EXPECT_FALSE(load.byId(""));
}

TEST(ColladaDocumentTest, ofTwoElementsWithOneIdTheFirstIsMeant) {
    TestLoad load("<COLLADA>\n<node id='a' name='first'/>\n<node id='a' name='second'/></COLLADA>");
    EXPECT_EQ(load.byId("a").attribute("name"), "first");
    ASSERT_THAT(codes(load.diagnostics.all()), testing::ElementsAre("WC0108"));
    EXPECT_THAT(load.diagnostics.all()[0], says("WC0108", 3, "COLLADA/node[id=a]"));
    EXPECT_THAT(load.diagnostics.all()[0].message, HasSubstr("line 2"));
}

TEST(ColladaDocumentTest, whatIsNoXmlIsRefusedWithALine) {
    EXPECT_THAT(refusal(""), says("WC0102", 1, ""));
    EXPECT_EQ(refusal("   \n ").code, "WC0102");
    EXPECT_EQ(refusal("solid cube").code, "WC0102");
    EXPECT_EQ(refusal("{\"asset\": 1}").code, "WC0102");
    EXPECT_THAT(refusal("<COLLADA>\n<asset>\n</COLLADA>"), says("WC0102", 2, ""));
    EXPECT_THAT(refusal("<COLLADA>\n<node id=hip/></COLLADA>"), says("WC0102", 2, ""));
    EXPECT_THAT(refusal("<COLLADA>\n<!-- no end </COLLADA>"), says("WC0102", 2, ""));
}

TEST(ColladaDocumentTest, aDocumentCutShortAnywhereIsRefused) {
    const std::string whole = collada(triangle()), text = whole.substr(0, whole.find_last_of('<'));
    for (std::size_t length = 0; length <= text.size(); length += 7)
        EXPECT_EQ(refusal(text.substr(0, length)).code, "WC0102") << length;
}

TEST(ColladaDocumentTest, xmlOfAnotherKindIsRefusedByName) {
    const Diagnostic svg = refusal("<?xml version='1.0'?>\n<svg/>");
    EXPECT_THAT(svg, says("WC0105", 2, "svg"));
    EXPECT_THAT(svg.message, HasSubstr("<svg>"));
}

TEST(ColladaDocumentTest, aZeroByteIsNotTheEnd) {
    using namespace std::string_literals;
    EXPECT_NE(refusal("<COLLADA>\n\0</COLLADA>"s).code, "");
    EXPECT_EQ(refusal("<COLLADA>\n</COLLADA>\0\0"s).code, "") << "padding at the end is harmless";
}

TEST(ColladaDocumentTest, entitiesAreRefusedAndAPlainDoctypeIsNot) {
    EXPECT_THAT(refusal("<!DOCTYPE COLLADA [\n<!ENTITY lol 'lol'>]>\n<COLLADA>&lol;</COLLADA>"),
                says("WC0112", 2, ""));
    EXPECT_EQ(refusal("<!DOCTYPE d [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><dae:COLLADA/>").code, "WC0112");
    EXPECT_EQ(refusal("<!DOCTYPE COLLADA>\n<COLLADA/>").code, "");
}

TEST(ColladaDocumentTest, sixtyFourLevelsAreReadAndTwoHundredRefused) {
    EXPECT_EQ(refusal(nested(64)).code, "");
    const Diagnostic tooDeep = refusal(nested(200));
    EXPECT_EQ(tooDeep.code, "WC0104");
    EXPECT_GT(tooDeep.line, 64);
    EXPECT_LT(tooDeep.line, 200);
}

TEST(ColladaDocumentTest, everyEncodingOfExportersIsRead) {
    const std::string text =
        "<COLLADA>\n<node id='h\xC3\xBC"
        "fte'/></COLLADA>";
    EXPECT_TRUE(
        TestLoad(text).byId("h\xC3\xBC"
                            "fte"));
    EXPECT_TRUE(TestLoad("\xEF\xBB\xBF" + text)
                    .byId("h\xC3\xBC"
                          "fte"));
    for (const bool bigEndian : {false, true}) {
        std::string utf16 = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
        for (const char c : std::string("<COLLADA><node id='h\xFC"
                                        "fte'/></COLLADA>"))
            utf16 += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
        EXPECT_TRUE(
            TestLoad(utf16).byId("h\xC3\xBC"
                                 "fte"))
            << bigEndian;
    }
    TestLoad latin(
        "<?xml version='1.0' encoding='ISO-8859-1'?>\n<COLLADA><node id='h\xFC"
        "fte'/></COLLADA>");
    EXPECT_TRUE(
        latin.byId("h\xC3\xBC"
                   "fte"));
    EXPECT_THAT(latin.diagnostics.all(), testing::IsEmpty());
}

TEST(ColladaDocumentTest, textThatIsNotWhatItClaimsIsReadAsWindows1252WithAWarning) {
    TestLoad load(
        "<?xml version='1.0' encoding='utf-8'?>\n<COLLADA><node id='h\xFC"
        "fte'/></COLLADA>");
    EXPECT_TRUE(
        load.byId("h\xC3\xBC"
                  "fte"));
    EXPECT_THAT(codes(load.diagnostics.all()), testing::ElementsAre("WC0113"));
}

}  // namespace
}  // namespace walkcycle
