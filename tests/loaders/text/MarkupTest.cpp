#include <optional>
#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/text/Markup.h"

namespace walkcycle {
namespace {

TEST(MarkupTest, instructionsGoAndTheirLinesStay) {
    EXPECT_EQ(withoutInstructions("<?xml version='1.0'?>\n<?style\nx?><a>1<?y?>2</a>").value_or(""),
              "<?xml version='1.0'?>\n\n<a>12</a>");
}

TEST(MarkupTest, whatOnlyLooksLikeAnInstructionStays) {
    for (const std::string text : {"<a><!-- <?x?> --></a>", "<a><![CDATA[<?x?>]]></a>", "<a b='<?x?>'/>",
                                   "<a><?x</a>", "<!DOCTYPE a [<?x?>]><a/>", "<?xml version='1.0'?><a/>", ""})
        EXPECT_EQ(withoutInstructions(text), std::nullopt) << text;
}

TEST(MarkupTest, aTagOfManyAttributesIsFound) {
    std::string crowded = "<a x='1'>text '''''''''''''' <b";
    for (int i = 0; i < 5; ++i) crowded += " a" + std::to_string(i) + "='>'";
    EXPECT_EQ(findCrowdedTag(crowded + "/></a>", 4), crowded.find("<b"));
    EXPECT_EQ(findCrowdedTag(crowded + "/></a>", 5), std::string::npos);
}

TEST(MarkupTest, aDocumentMayHoldInstructionsForOtherPrograms) {
    const std::string text = "<?xml version='1.0'?>\n<!-- -->\n<?xml-stylesheet href='a.css'?>\n" +
                             collada(scene("<node><?mark?>\n<translate>1 2 x</translate></node>"));
    const Model model = loadText(text);
    ASSERT_EQ(codes(model.diagnostics), std::vector<std::string>{"WC0204"});
    EXPECT_EQ(model.diagnostics[0].line, lineOf(text, "<translate"));
}

TEST(MarkupTest, anElementOfTenThousandAttributesIsRefusedInItsLine) {
    std::string node = "<node";
    for (int i = 0; i < 10'000; ++i) node += " a" + std::to_string(i) + "=''";
    const std::string text = collada(scene("\n" + node + "/>"));
    const Diagnostic reason = whyNot(text);
    EXPECT_EQ(reason.code, "WC0102");
    EXPECT_EQ(reason.line, lineOf(text, "<node"));
}

// tinyxml2 takes a '<' within quotes, which must not make one crowded tag look like many.
TEST(MarkupTest, anElementOfTenThousandAttributesCannotHideBehindTheirValues) {
    std::string node = "<node";
    for (int i = 0; i < 10'000; ++i) node += " a" + std::to_string(i) + "='<'";
    const std::string text = collada(scene("\n" + node + "/>"));
    EXPECT_EQ(whyNot(text).line, lineOf(text, "<node"));
    EXPECT_EQ(whyNot("<!DOCTYPE COLLADA>" + text).line, lineOf(text, "<node"));
}

TEST(MarkupTest, theFirstElementThatIsTooManyIsFound) {
    const std::string text = "<?xml version='1.0'?><a><!-- <b/> --><c d='<e/>'/></a><f/>";
    EXPECT_EQ(findMarkupBeyond(text, 0), text.find("<a>"));
    EXPECT_EQ(findMarkupBeyond(text, 1), text.find("<!--"));
    EXPECT_EQ(findMarkupBeyond(text, 2), text.find("<c"));
    EXPECT_EQ(findMarkupBeyond(text, 3), text.find("<f"));
    EXPECT_EQ(findMarkupBeyond(text, 4), std::string::npos);
    EXPECT_EQ(findMarkupBeyond("<!DOCTYPE a [<!ELEMENT a ANY>]><a/><b/>", 3), 35u);
}

}  // namespace
}  // namespace walkcycle
