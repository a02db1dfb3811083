#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/text/MarkupScanner.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Kind = MarkupScanner::Kind;

// "<a>" for each markup; "..." at the end of one that is cut short.
std::vector<std::string> markupOf(std::string_view text) {
    std::vector<std::string> all;
    for (MarkupScanner markup(text); markup.next();)
        all.push_back(markup.end() == MarkupScanner::kNone
                          ? std::string(text.substr(markup.begin())) + "..."
                          : std::string(text.substr(markup.begin(), markup.end() - markup.begin())));
    return all;
}

std::vector<Kind> kindsOf(std::string_view text) {
    std::vector<Kind> all;
    for (MarkupScanner markup(text); markup.next();) all.push_back(markup.kind());
    return all;
}

TEST(MarkupScannerTest, tagsAreFoundBetweenText) {
    EXPECT_THAT(markupOf("<a>1 2<b c='3'/>4</a>\n"), ElementsAre("<a>", "<b c='3'/>", "</a>"));
    EXPECT_THAT(markupOf("no markup"), IsEmpty());
    EXPECT_THAT(markupOf(""), IsEmpty());
}

TEST(MarkupScannerTest, aTagEndsBehindItsQuotes) {
    EXPECT_THAT(markupOf("<a b='>' c=\"'<x>\"><d/>"), ElementsAre("<a b='>' c=\"'<x>\">", "<d/>"));
}

TEST(MarkupScannerTest, whatOnlyLooksLikeATagIsNone) {
    EXPECT_THAT(markupOf("<!-- <a> -- > --><b/>"), ElementsAre("<!-- <a> -- > -->", "<b/>"));
    EXPECT_THAT(markupOf("<![CDATA[<a>]>]]><b/>"), ElementsAre("<![CDATA[<a>]>]]>", "<b/>"));
    EXPECT_THAT(markupOf("<?style <a> ?><b/>"), ElementsAre("<?style <a> ?>", "<b/>"));
    EXPECT_THAT(markupOf("<!--><b/>-->"), ElementsAre("<!--><b/>-->"));
}

TEST(MarkupScannerTest, eachKindIsTold) {
    EXPECT_THAT(kindsOf("<?xml?><!-- --><a><![CDATA[]]></a>"),
                ElementsAre(Kind::Instruction, Kind::Comment, Kind::StartTag, Kind::CData, Kind::EndTag));
    EXPECT_THAT(kindsOf("<!DOCTYPE a>"), ElementsAre(Kind::Declaration));
}

TEST(MarkupScannerTest, whatIsCutShortIsTheLast) {
    for (const std::string cut : {"<a", "<a b='>", "</a", "<!-- <b>", "<![CDATA[<b>", "<?x", "<", "<!"})
        EXPECT_THAT(markupOf("<a>" + cut), ElementsAre("<a>", cut + "...")) << cut;
}

TEST(MarkupScannerTest, attributesAreCounted) {
    MarkupScanner markup("<a b='1' c=\"2\" d=''/><e>");
    ASSERT_TRUE(markup.next());
    EXPECT_EQ(markup.attributes(), 3u);
    ASSERT_TRUE(markup.next());
    EXPECT_EQ(markup.attributes(), 0u);
}

TEST(MarkupScannerTest, goesOnFromWhereItIsMoved) {
    const std::string_view text = "<p>1 < 2</p><q/>";
    MarkupScanner markup(text);
    ASSERT_TRUE(markup.next());
    markup.moveTo(text.find("</p"));
    ASSERT_TRUE(markup.next());
    EXPECT_EQ(markup.kind(), Kind::EndTag);
}

}  // namespace
}  // namespace walkcycle
