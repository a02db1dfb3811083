#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/CodeCases.h"
#include "loaders/TestFiles.h"

namespace walkcycle {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::vector<CodeCase> allCases() {
    std::vector<CodeCase> all;
    for (const auto& chapter : {documentCases(), referenceCases(), geometryCases(), skinCases(),
                                animationCases(), materialCases(), sceneCases()})
        all.insert(all.end(), chapter.begin(), chapter.end());
    return all;
}

// A file that cannot be read is no document (see below); 09xx are met outside of documents, 10xx are the profiles of
// `check`: they have their own tests.
bool isTestedElsewhere(const CodeInfo& entry) {
    return entry.code == Code::FileUnreadable || std::string_view(entry.id).size() > 6 ||
           std::string_view(entry.id) >= "WC0900";
}

std::vector<Diagnostic> whatIsSaid(const CodeCase& damaged, const std::string& document) {
    const TestFolder folder;
    try {
        if (!damaged.isOnDisk) return loadText(document, damaged.options).diagnostics;
        return loadCollada(folder.write("test.dae", document), damaged.options).diagnostics;
    } catch (const LoadError& error) {
        return error.diagnostics;
    }
}

class EveryCodeTest : public testing::TestWithParam<CodeCase> {};

TEST_P(EveryCodeTest, saysLineAndElementOfTheDamage) {
    const CodeCase& damaged = GetParam();
    const CodeInfo& entry = info(damaged.code);
    std::string document = damaged.document;
    const int line = lineOf(document, "@");
    if (line > 0) document.erase(document.find('@'), 1);

    const std::vector<Diagnostic> said = whatIsSaid(damaged, document);
    EXPECT_THAT(said, Contains(says(entry.id, line, damaged.path))) << document;
    const auto found =
        std::ranges::find_if(said, [&](const Diagnostic& one) { return one.code == entry.id; });
    ASSERT_NE(found, said.end());
    EXPECT_EQ(found->severity, entry.severity);
    EXPECT_THAT(toString(*found),
                HasSubstr(std::string(": ") + nameOf(entry.severity) + " " + entry.id + ": "));
    EXPECT_EQ(found->message.find('{'), std::string::npos) << "a place that nobody filled in";
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryCodeTest, testing::ValuesIn(allCases()),
                         [](const auto& row) { return std::string(walkcycle::info(row.param.code).name); });

TEST(CatalogueTest, everyCodeHasACaseThatRaisesIt) {
    std::set<Code> raised;
    for (const CodeCase& one : allCases()) raised.insert(one.code);
    for (const CodeInfo& entry : diagnosticCatalogue())
        EXPECT_TRUE(raised.contains(entry.code) || isTestedElsewhere(entry)) << entry.id << " " << entry.name;
}

TEST(CatalogueTest, aFileThatCannotBeReadIsNamedWithoutALine) {
    try {
        loadCollada("/nowhere/at/all.dae");
        FAIL();
    } catch (const LoadError& error) {
        EXPECT_THAT(error.diagnostics.back(), says("WC0101", 0, ""));
        EXPECT_THAT(error.what(), StartsWith("/nowhere/at/all.dae: error WC0101: "));
    }
}

TEST(CatalogueTest, whatAnAuthorCanMendIsSaidForAllThreePrograms) {
    for (const CodeInfo& entry : diagnosticCatalogue()) {
        EXPECT_EQ(*entry.inBlender == '\0', *entry.inMaya == '\0') << entry.id;
        EXPECT_EQ(*entry.inBlender == '\0', *entry.in3dsMax == '\0') << entry.id;
        if (isTestedElsewhere(entry)) continue;
        EXPECT_EQ(std::string(entry.cure).find("Blender"), std::string::npos) << entry.id;
    }
}

}  // namespace

void PrintTo(const CodeCase& damaged, std::ostream* out) {
    *out << info(damaged.code).id;
}

}  // namespace walkcycle
