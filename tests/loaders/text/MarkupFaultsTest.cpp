// Documents whose markup or references are odd in ways that exporters and hands produce.
#include <string>

#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/document/ColladaDocument.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MarkupFaultsTest, aCdataSectionWithoutAnEndIsSaid) {
    const Diagnostic why = whyNot("<COLLADA>\n<asset><![CDATA[ never closed </asset></COLLADA>");
    EXPECT_EQ(why.code, "WC0102");
    EXPECT_THAT(why.message, HasSubstr("CDATA"));
    EXPECT_EQ(why.line, 2);
}

TEST(MarkupFaultsTest, aSecondRootElementIsNamed) {
    const Diagnostic why = whyNot("<COLLADA version='1.4.1'/>\n<asset/>");
    EXPECT_EQ(why.code, "WC0102");
    EXPECT_THAT(why.message, HasSubstr("<asset>"));
    EXPECT_EQ(why.line, 2);
}

TEST(MarkupFaultsTest, aDocumentOfCommentsOnlyHasNoElement) {
    EXPECT_EQ(whyNot("<!-- nothing -->").code, "WC0102");
    EXPECT_EQ(whyNot("<?xml version='1.0'?>\n<!-- nothing -->\n").code, "WC0102");
}

TEST(MarkupFaultsTest, aZeroCharacterInTheMiddleIsSaidWithItsLine) {
    using namespace std::string_literals;
    std::string text = collada(triangle() + scene("<node><instance_geometry url='#mesh'/></node>"));
    const int line = lineOf(text, "<library_visual_scenes");
    text.insert(text.find("<library_visual_scenes"), "\0"s);
    const Diagnostic why = whyNot(text);
    EXPECT_EQ(why.code, "WC0103");
    EXPECT_THAT(why.message, HasSubstr("zero character"));
    EXPECT_EQ(why.line, line);
}

TEST(MarkupFaultsTest, whatLooksLikeADoctypeInsideACommentIsNone) {
    const std::string shown = triangle() + scene("<node><instance_geometry url='#mesh'/></node>");
    const Model model = loadText(collada("<!-- <!DOCTYPE x [<!ENTITY y 'z'>]> -->\n" + shown));
    EXPECT_THAT(model.diagnostics, IsEmpty());
    EXPECT_EQ(model.instances.size(), 1u);
}

TEST(MarkupFaultsTest, anEmptyIdIsNone) {
    const Model model = loadText(
        collada(triangle() + scene("<node id=''/><node id=''><instance_geometry url='#mesh'/></node>")));
    EXPECT_THAT(model.diagnostics, IsEmpty());
    EXPECT_EQ(model.skeleton.joints.size(), 2u);
}

TEST(MarkupFaultsTest, theOldFormatsAreNamed) {
    const std::string shown = triangle() + scene("<node><instance_geometry url='#mesh'/></node>");
    for (const char* version : {"1.3.1", "1.2.0", "1.1"}) {
        std::string text = collada(shown);
        text.replace(text.find("1.4.1"), 5, version);
        const Diagnostic why = whyNot(text);
        EXPECT_THAT(why.message, HasSubstr(version));
        EXPECT_EQ(why.line, 2);
    }
}

// Long lists are cut out of the text before the markup is read, and must come back whatever stands about them.
TEST(MarkupFaultsTest, longListsAreReadHoweverTheirTagsAreWritten) {
    const std::string numbers = "0 0 0 1 0 0 0 1 0" + std::string(200, ' ') + std::string(3, '\n');
    const std::string plain =
        "<float_array id=\"mesh-positions-array\" count=\"9\">" + numbers + "</float_array>";
    const std::string text =
        collada(triangle("mesh", numbers) + scene("<node><instance_geometry url='#mesh'/></node>"));
    ASSERT_NE(text.find(plain), text.npos);
    for (const std::string& odd :
         {"<float_array\tid=\"mesh-positions-array\" count=\"9\">" + numbers + "</float_array>",
          "<float_array\r\nid=\"mesh-positions-array\" count=\"9\">" + numbers + "</float_array>",
          "<float_array\nid=\"mesh-positions-array\" count=\"9\">" + numbers + "</float_array\n>",
          "<float_array id=\"empty\" count=\"0\"/>" + plain,
          "<float_array id=\"mesh-positions-array\" count=\"9\">&#48; " + numbers.substr(2) +
              "</float_array>",
          "<float_array id=\"mesh-positions-array\" count=\"9\">" + numbers.substr(0, 4) + "<!-- -->" +
              numbers.substr(4) + "</float_array>"}) {
        std::string changed = text;
        const Model model = loadText(changed.replace(text.find(plain), plain.size(), odd));
        EXPECT_THAT(posed(model), ElementsAre(isAt(0, 0, 0), isAt(1, 0, 0), isAt(0, 1, 0))) << odd;
    }
    std::string crossed = text;
    crossed.replace(text.find("</float_array>"), 14, "</int_array>");
    EXPECT_EQ(whyNot(crossed).code, "WC0102");
}

}  // namespace
}  // namespace walkcycle
