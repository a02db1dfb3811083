#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "Snippets.h"
#include "SourceTree.h"

using namespace walkcycle::house;
using testing::HasSubstr;

namespace {

std::vector<std::string> pages() {
    auto files = filesBelow("docs", {".md"});
    for (const char* page : {"README.md", "CONTRIBUTING.md"}) {
        if (std::filesystem::exists(root() / page)) files.emplace_back(page);
    }
    return files;
}

const char* const kSource = R"(#include <vector>

int half(int x);  // a declaration is not it

// Half of it; "}" in a comment does not end it.
int half(int x) {
    const char* brace = "{";
    return brace ? x / 2 : 0;
}

// What it is.
struct Thing {
    int a = 0;
    // Twice a.
    int twice() const { return 2 * a; }
};

inline constexpr int kNothing = -1;
)";

}  // namespace

TEST(SnippetTest, pagesQuoteTheSourcesAsTheyAre) {
    for (const std::string& file : pages()) {
        const std::string page = readText(root() / file);
        const std::string fresh = withFreshQuotes(page);
        if (updatesDocs()) {
            writeText(root() / file, fresh);
        } else {
            EXPECT_EQ(page, fresh) << file << ": run the tests with UPDATE_DOCS=1, and read it again";
        }
    }
}

TEST(SnippetTest, aDefinitionComesWithItsCommentAndEndsAtItsBrace) {
    EXPECT_EQ(findDefinition(kSource, "half"),
              "// Half of it; \"}\" in a comment does not end it.\n"
              "int half(int x) {\n    const char* brace = \"{\";\n    return brace ? x / 2 : 0;\n}\n");
    EXPECT_EQ(findDefinition(kSource, "twice"), "// Twice a.\nint twice() const { return 2 * a; }\n");
    EXPECT_EQ(findDefinition(kSource, "kNothing"), "inline constexpr int kNothing = -1;\n");
    EXPECT_THAT(findDefinition(kSource, "struct Thing"), HasSubstr("};\n"));
    EXPECT_THROW(findDefinition(kSource, "third"), std::runtime_error);
}

TEST(SnippetTest, onlyFencesThatNameAFileAndADefinitionAreQuotes) {
    const auto fences = quotingFences(
        "```cpp\nint x;\n```\n"
        "text\n```cpp src/a/B.cpp B::c\nold\n```\n");
    ASSERT_EQ(fences.size(), 1u);
    EXPECT_EQ(fences[0].file, "src/a/B.cpp");
    EXPECT_EQ(fences[0].definition, "B::c");
    EXPECT_EQ(fences[0].text, "old\n");
}
