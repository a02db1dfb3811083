#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/document/XmlNode.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(XmlNodeTest, aMissingElementGivesMoreNothing) {
    TestLoad load("<COLLADA/>");
    const XmlNode nothing = load.collada.child("scene").child("instance_visual_scene");
    EXPECT_FALSE(nothing);
    EXPECT_FALSE(nothing.is(""));
    EXPECT_FALSE(nothing.has("url"));
    EXPECT_EQ(nothing.attribute("url"), "");
    EXPECT_EQ(nothing.text(), "");
    EXPECT_EQ(nothing.line(), 0);
    EXPECT_EQ(nothing.path(), "");
    EXPECT_EQ(nothing.file(), "");
    EXPECT_FALSE(nothing.parent());
    for (XmlNode child : nothing.children()) ADD_FAILURE() << child.name();
}

TEST(XmlNodeTest, childrenComeInDocumentOrderByNameOrAll) {
    TestLoad load("<COLLADA><a n='1'/><!-- c --><b n='2'/>text<a n='3'/></COLLADA>");
    std::vector<std::string> named, all;
    for (XmlNode node : load.collada.children("a")) named.emplace_back(node.attribute("n"));
    for (XmlNode node : load.collada.children()) all.emplace_back(node.attribute("n"));
    EXPECT_THAT(named, ElementsAre("1", "3"));
    EXPECT_THAT(all, ElementsAre("1", "2", "3"));
}

std::vector<std::string> namesBelow(XmlNode node) {
    std::vector<std::string> names;
    for (XmlNode element : node.descendants()) names.emplace_back(element.name());
    return names;
}

TEST(XmlNodeTest, descendantsComeInDocumentOrderEachBeforeItsChildren) {
    TestLoad load("<COLLADA><a><b><c/></b>text<d/></a><!-- --><e><f/></e></COLLADA>");
    EXPECT_THAT(namesBelow(load.collada), ElementsAre("a", "b", "c", "d", "e", "f"));
    EXPECT_THAT(namesBelow(load.collada.child("a")), ElementsAre("b", "c", "d")) << "and no further";
    EXPECT_THAT(namesBelow(load.collada.child("e").child("f")), IsEmpty());
    EXPECT_THAT(namesBelow(XmlNode()), IsEmpty());
}

TEST(XmlNodeTest, descendantsKnowTheirDepthAndMayBePassedBy) {
    TestLoad load("<COLLADA><a><b><c/></b><d/></a><e/></COLLADA>");
    std::vector<std::string> seen;
    const XmlNode::Descendants all = load.collada.descendants();
    for (auto element = all.begin(); element != all.end(); ++element) {
        seen.push_back(std::string(element->name()) + std::to_string(element.depth()));
        if (element->is("b")) element.skipChildren();
    }
    EXPECT_THAT(seen, ElementsAre("a1", "b2", "d2", "e1"));
}

TEST(XmlNodeTest, everyElementLeadsToItsRootAndToTheOthersById) {
    TestLoad load("<COLLADA><a><b id='b'/></a><c id='c'/></COLLADA>");
    const XmlNode b = load.collada.child("a").child("b");
    EXPECT_EQ(b.root(), load.collada);
    EXPECT_EQ(b.elementById("c"), load.collada.child("c"));
    EXPECT_FALSE(b.elementById("d"));
    EXPECT_FALSE(XmlNode().elementById("c"));
    EXPECT_FALSE(XmlNode().root());
}

TEST(XmlNodeTest, aPrefixIsNoPartOfTheName) {
    TestLoad load("<dae:COLLADA><dae:node id='n'/></dae:COLLADA>");
    EXPECT_TRUE(load.collada.is("COLLADA"));
    EXPECT_EQ(load.collada.child("node").path(), "COLLADA/node[id=n]");
}

TEST(XmlNodeTest, textGoesOnAfterACommentAndInACdataSection) {
    TestLoad load("<COLLADA><p> 1 2 <!-- 9 --> 3 <![CDATA[4]]> </p></COLLADA>");
    EXPECT_EQ(load.collada.child("p").text(), "1 2  3 4");
}

TEST(XmlNodeTest, aCommentDoesNotEndANumberAndAnElementDoes) {
    TestLoad load(
        "<COLLADA><p>1<!-- . -->2<![CDATA[3]]>4</p><q>1<x/>2</q><r><!-- --> <![CDATA[1]]> <!-- "
        "-->2</r></COLLADA>");
    EXPECT_EQ(load.collada.child("p").text(), "1234");
    EXPECT_EQ(load.collada.child("q").text(), "1 2");
    EXPECT_EQ(load.collada.child("r").text(), "1 2");
}

TEST(XmlNodeTest, aPieceOfTextBehindACommentHasItsOwnLine) {
    TestLoad load("<COLLADA><p>1\n2<!-- -->3\n4<x/>\n<![CDATA[5]]></p></COLLADA>");
    const XmlNode p = load.collada.child("p");
    std::string joined;
    const std::string text(p.rawText(joined));
    EXPECT_EQ(p.textLine(text.find('3')), 2);
    EXPECT_EQ(p.textLine(text.find('4')), 3);
    EXPECT_EQ(p.textLine(text.find('5')), 4);
}

TEST(XmlNodeTest, thePathNamesIdsAndSids) {
    TestLoad load(
        "<COLLADA><node id='hip'><node sid='knee'><node><translate/></node></node></node></COLLADA>");
    const XmlNode node = load.byId("hip").child("node").child("node").child("translate");
    EXPECT_EQ(node.path(), "COLLADA/node[id=hip]/node[sid=knee]/node/translate");
}

TEST(XmlNodeTest, linesCountThroughCommentsAndBlankLines) {
    TestLoad load("<COLLADA>\n<!-- a\nb -->\n\n<p>\n\n  1</p>\n</COLLADA>");
    EXPECT_EQ(load.collada.child("p").line(), 5);
}

}  // namespace
}  // namespace walkcycle
