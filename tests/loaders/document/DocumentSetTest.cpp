#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "loaders/LoadText.h"
#include "loaders/TestFiles.h"

namespace walkcycle {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// What `uri` leads to from the <from> of the document.
XmlNode resolved(TestLoad& load, std::string_view uri) {
    return load.documents.resolve(load.collada.child("from"), uri);
}

// (In a namespace of their own, elements may be called as one likes.)
std::string here(const std::string& id) {
    return "<COLLADA><from xmlns='urn:test'/><node xmlns='urn:test' id='" + id + "'/></COLLADA>";
}

// Other documents by path, each with a <node> of its own; counts how often each is asked for.
struct Others {
    std::map<std::string, std::string> texts;
    std::map<std::string, int> asked;

    LoadOptions options() {
        LoadOptions result;
        result.resolver = [this](const std::string& path) -> std::optional<Bytes> {
            ++asked[path];
            const auto found = texts.find(path);
            return found == texts.end() ? std::nullopt : std::optional(bytesOf(found->second));
        };
        return result;
    }
};

TEST(DocumentSetTest, aFragmentLeadsToTheIdInTheSameDocument) {
    TestLoad load(here("a.b-c"));
    EXPECT_TRUE(resolved(load, "#a.b-c"));
    EXPECT_TRUE(resolved(load, " #a.b-c "));
    EXPECT_TRUE(resolved(load, "a.b-c")) << "an id alone, as a courtesy";
    EXPECT_FALSE(resolved(load, "#gone"));
    EXPECT_FALSE(resolved(load, "#"));
    EXPECT_FALSE(resolved(load, ""));
    EXPECT_THAT(load.diagnostics.all(), IsEmpty());
}

TEST(DocumentSetTest, percentEscapesAreDecodedWhereTheIdIsNotThereAsItStands) {
    TestLoad spaced(here("left leg"));
    EXPECT_TRUE(resolved(spaced, "#left%20leg"));
    TestLoad escaped(here("left%20leg"));
    EXPECT_TRUE(resolved(escaped, "#left%20leg"));
}

TEST(DocumentSetTest, aDocumentThatNamesItselfMeansItself) {
    TestLoad load(here("a"));
    EXPECT_EQ(resolved(load, "test.dae#a"), load.byId("a"));
    EXPECT_EQ(resolved(load, "./test.dae#a"), load.byId("a"));
    EXPECT_EQ(resolved(load, "te%73t.dae#a"), load.byId("a"));
    EXPECT_THAT(load.diagnostics.all(), IsEmpty());
}

TEST(DocumentSetTest, anotherDocumentIsOpenedOnceHoweverItIsNamed) {
    Others others{{{"parts/legs.dae", here("leg")}}, {}};
    TestLoad load(here("a"), others.options());
    const XmlNode leg = resolved(load, "parts/legs.dae#leg");
    EXPECT_EQ(leg.attribute("id"), "leg");
    EXPECT_EQ(leg.file(), "parts/legs.dae");
    EXPECT_EQ(resolved(load, "./parts/../parts/legs.dae#leg"), leg);
    EXPECT_EQ(resolved(load, "parts\\legs.dae#leg"), leg);
    EXPECT_EQ(others.asked["parts/legs.dae"], 1);
}

TEST(DocumentSetTest, documentsMayReferToEachOther) {
    Others others{{{"b.dae", here("b")}}, {}};
    TestLoad load(here("a"), others.options());
    const XmlNode b = resolved(load, "b.dae#b");
    ASSERT_TRUE(b);
    EXPECT_EQ(load.documents.resolve(b, "test.dae#a"), load.byId("a"));
    EXPECT_EQ(load.documents.resolve(b, "#a"), XmlNode()) << "ids belong to their document";
}

TEST(DocumentSetTest, aPathIsMeantFromTheDocumentThatSaysIt) {
    Others others{{{"parts/b.dae", here("b")}, {"parts/c.dae", here("c")}}, {}};
    TestLoad load(here("a"), others.options());
    EXPECT_TRUE(load.documents.resolve(resolved(load, "parts/b.dae#b"), "c.dae#c"));
}

TEST(DocumentSetTest, aMissingDocumentIsReportedOnceAndTheReferenceEachTime) {
    Others others;
    TestLoad load("<COLLADA>\n<a url='gone.dae#x'/>\n<b url='gone.dae#y'/></COLLADA>", others.options());
    EXPECT_FALSE(load.documents.follow(load.collada.child("a"), "url", "node"));
    EXPECT_FALSE(load.documents.follow(load.collada.child("b"), "url", "node"));
    EXPECT_THAT(load.diagnostics.all(),
                ElementsAre(says("WC0209", 2, "COLLADA/a"), says("WC0201", 2, "COLLADA/a"),
                            says("WC0201", 3, "COLLADA/b")));
    EXPECT_EQ(others.asked["gone.dae"], 1);
}

TEST(DocumentSetTest, aBrokenDocumentIsReportedWithItsOwnFileAndLine) {
    Others others{{{"b.dae", "<COLLADA>\n<node>\n</COLLADA>"}}, {}};
    TestLoad load("<COLLADA>\n<from url='b.dae#x'/></COLLADA>", others.options());
    load.documents.follow(load.collada.child("from"), "url", "node");
    ASSERT_THAT(codes(load.diagnostics.all()), ElementsAre("WC0102", "WC0209", "WC0201"));
    EXPECT_EQ(load.diagnostics.all()[0].file, "b.dae");
    EXPECT_EQ(load.diagnostics.all()[0].line, 2);
    EXPECT_EQ(load.diagnostics.all()[1].file, "test.dae");
}

TEST(DocumentSetTest, followSaysWhatIsMissingOrOfAnotherKind) {
    TestLoad load("<COLLADA>\n<a/>\n<b url=''/>\n<c url='#n'/>\n<node id='n'/></COLLADA>");
    EXPECT_FALSE(load.documents.follow(load.collada.child("a"), "url", "camera"));
    EXPECT_FALSE(load.documents.follow(load.collada.child("b"), "url", "camera"));
    EXPECT_FALSE(load.documents.follow(load.collada.child("c"), "url", "camera"));
    EXPECT_TRUE(load.documents.follow(load.collada.child("c"), "url", "node"));
    EXPECT_THAT(load.diagnostics.all(),
                ElementsAre(says("WC0202", 2, "COLLADA/a"), says("WC0201", 3, "COLLADA/b"),
                            says("WC0207", 4, "COLLADA/c")));
}

TEST(DocumentSetTest, theNetworkIsNeverAsked) {
    Others others;
    TestLoad load(here("a"), others.options());
    EXPECT_FALSE(resolved(load, "http://example.com/b.dae#b"));
    EXPECT_THAT(others.asked, IsEmpty());
}

TEST(DocumentSetTest, theLimitOfOtherDocumentsHoldsAtItsDocument) {
    Others others;
    for (const char* name : {"b", "c", "d"}) others.texts[std::string(name) + ".dae"] = here(name);
    LoadOptions options = others.options();
    options.limits.maxDocuments = 2;
    TestLoad load(here("a"), options);
    EXPECT_TRUE(resolved(load, "b.dae#b"));
    EXPECT_TRUE(resolved(load, "c.dae#c"));
    EXPECT_TRUE(resolved(load, "b.dae#b"));
    EXPECT_THROW(resolved(load, "d.dae#d"), LoadError);
    EXPECT_EQ(load.diagnostics.all().back().code, "WC0801");
}

TEST(DocumentSetTest, aDocumentOnDiskIsFoundInAnotherCaseAndStaysOneDocument) {
    const TestFolder folder;
    folder.write("Parts/Legs.dae", here("leg"));
    const std::string path = folder.write("walker.dae", here("a"));
    LoadOptions options;
    Diagnostics diagnostics;
    DocumentSet documents(options, diagnostics);
    const XmlNode from = documents.openFile(path).root().child("from");
    const XmlNode leg = documents.resolve(from, "Parts/legs.DAE#leg");
    ASSERT_TRUE(leg);
    EXPECT_EQ(documents.resolve(from, "Parts/Legs.dae#leg"), leg);
    EXPECT_EQ(documents.resolve(from, "Walker.DAE#a"), from.elementById("a"));
    EXPECT_THAT(diagnostics.all(), IsEmpty());
}

TEST(DocumentSetTest, whatIsNoFileIsRefusedInOneSentence) {
    const TestFolder folder;
    const auto code = [](const std::string& path) {
        try {
            loadCollada(path);
        } catch (const LoadError& error) {
            return error.diagnostics.back().code;
        }
        return std::string();
    };
    EXPECT_EQ(code(folder.path("gone.dae")), "WC0101");
    EXPECT_EQ(code(folder.path(".")), "WC0101");
    EXPECT_EQ(code(folder.write("empty.dae", "")), "WC0102");
    EXPECT_EQ(code(folder.write("broken.zae", "PK\x03\x04 and no more")), "WC0109");
    EXPECT_EQ(code(folder.write("broken.gz", "\x1F\x8B\x08 and no more")), "WC0109");
}

TEST(DocumentSetTest, archivesAreReadByManifestOrByTheOnlyDocument) {
    const std::string text = here("a");
    const auto root = [](const Bytes& bytes) {
        LoadOptions options;
        Diagnostics diagnostics;
        DocumentSet documents(options, diagnostics);
        return std::string(documents.openMemory(bytes, "test.zae").root().child("node").id());
    };
    EXPECT_EQ(root(zipOf({{"readme.txt", "no"}, {"walker.dae", text}})), "a");
    EXPECT_EQ(root(zipOf({{"first.dae", here("first")},
                          {"manifest.xml", "<?xml version='1.0'?><dae_root>./sub/walker%201.dae</dae_root>"},
                          {"sub/walker 1.dae", text}})),
              "a");
    EXPECT_EQ(root(gzipOf(text)), "a");
}

TEST(DocumentSetTest, membersOfAnArchiveReferToEachOther) {
    const Bytes bytes = zipOf({{"sub/walker.dae", here("a")},
                               {"sub/legs.dae", here("leg")},
                               {"arms.dae", here("arm")},
                               {"manifest.xml", "<dae_root>sub/walker.dae</dae_root>"}});
    LoadOptions options;
    Diagnostics diagnostics;
    DocumentSet documents(options, diagnostics);
    const XmlNode from = documents.openMemory(bytes, "test.zae").root().child("from");
    EXPECT_TRUE(documents.resolve(from, "legs.dae#leg"));
    EXPECT_TRUE(documents.resolve(from, "LEGS.dae#leg"));
    EXPECT_TRUE(documents.resolve(from, "../arms.dae#arm"));
    EXPECT_THAT(diagnostics.all(), IsEmpty());
    EXPECT_FALSE(documents.resolve(from, "../../../etc/hosts.dae#x"));
}

TEST(DocumentSetTest, anArchiveLargerThanItsLimitsIsRefused) {
    LoadOptions options;
    options.limits.maxArchiveBytes = here("a").size() - 1;
    Diagnostics diagnostics;
    DocumentSet documents(options, diagnostics);
    EXPECT_THROW(documents.openMemory(zipOf({{"a.dae", here("a")}}), "test.zae"), LoadError);
    EXPECT_THROW(documents.openMemory(gzipOf(here("a")), "test.dae.gz"), LoadError);
    EXPECT_THAT(codes(diagnostics.all()), ElementsAre("WC0801", "WC0801"));
}

}  // namespace
}  // namespace walkcycle
