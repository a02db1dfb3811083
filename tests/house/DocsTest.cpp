#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "DiagnosticsPage.h"
#include "LimitsPage.h"
#include "SourceTree.h"

using namespace walkcycle::house;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

namespace {

std::vector<std::string> allMatches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        found.push_back((*match)[1]);
    }
    return found;
}

// A page's prose: what stands between fences is code.
std::string prose(const std::string& page) {
    std::string text;
    bool inFence = false;
    for (const std::string& line : splitLines(page)) {
        if (line.starts_with("```")) inFence = !inFence;
        if (!inFence) text += line + '\n';
    }
    return text;
}

std::vector<std::string> pages() {
    auto files = filesBelow("docs", {".md"});
    for (const char* page : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) files.emplace_back(page);
    return files;
}

}  // namespace

TEST(DocsTest, diagnosticsPageIsWhatTheCatalogueSays) {
    const auto file = root() / "docs/diagnostics.md";
    if (updatesDocs()) writeText(file, diagnosticsPage());
    EXPECT_EQ(readText(file), diagnosticsPage()) << "run the tests with UPDATE_DOCS=1";
}

TEST(DocsTest, diagnosticsPageHasWordsWhereMessagesTakeTheirsFromTheFile) {
    EXPECT_FALSE(std::regex_search(diagnosticsPage(), std::regex(R"(\{[0-9])")));
    EXPECT_NE(diagnosticsPage().find("&lt;ELEMENT&gt; refers to 'URI', which is not there"),
              std::string::npos);
}

TEST(DocsTest, thePageOnCheckingNamesEveryRuleOfAProfile) {
    const std::string rules = diagnosticsPage(), page = readText(root() / "docs/checking.md");
    const auto codes = allMatches(rules, std::regex("### (WC10[0-9]{2}) "));
    EXPECT_FALSE(codes.empty());
    for (const std::string& code : codes) EXPECT_NE(page.find("| " + code + " |"), std::string::npos) << code;
}

TEST(DocsTest, limitsPageIsWhatTheHeaderSays) {
    const auto file = root() / "docs/limits.md";
    if (updatesDocs()) writeText(file, limitsPage());
    EXPECT_EQ(readText(file), limitsPage()) << "run the tests with UPDATE_DOCS=1";
}

TEST(DocsTest, everyLinkWithinTheDocsLeadsToAFile) {
    const std::regex link(R"(\]\(([^)#]+)(?:#[^)]*)?\))");
    for (const std::string& page : pages()) {
        const auto folder = (root() / page).parent_path();
        for (const std::string& target : allMatches(prose(readText(root() / page)), link)) {
            if (target.find("://") != std::string::npos) continue;
            EXPECT_TRUE(std::filesystem::exists(folder / target)) << page << " links to " << target;
        }
    }
}

TEST(DocsTest, theTableOfErrorsNamesWhatPublicHeadersDeclare) {
    std::string headers;
    for (const std::string& header : filesBelow("include", {".h"})) headers += readText(root() / header);
    const std::string page = readText(root() / "docs/library.md"),
                      table = page.substr(page.find("\n## Errors"));
    EXPECT_THAT(allMatches(table, std::regex(R"(\n\| `(\w+)` \|)")), Not(IsEmpty()));
    for (const std::string& name : allMatches(table, std::regex("`(?:\\w+::)?(\\w+)(?:\\(\\))?`")))
        EXPECT_TRUE(std::regex_search(headers, std::regex("\\b" + name + "\\b"))) << name;
}

TEST(DocsTest, theJavaMapCoversAllClassesAndNamesFilesThatExist) {
    const std::string page = readText(root() / "docs/java-to-cpp.md");
    const auto classes = allMatches(page, std::regex(R"(\n\| `(\w+)` \|)"));
    EXPECT_THAT(classes, SizeIs(59));
    EXPECT_THAT(std::set<std::string>(classes.begin(), classes.end()),
                SizeIs(58));  // two are called AnimationLoader
    for (const std::string& file :
         allMatches(page, std::regex("`((?:src|tests|res|scripts|docs|examples)/[^`]*)`"))) {
        EXPECT_TRUE(std::filesystem::exists(root() / file)) << "docs/java-to-cpp.md names " << file;
    }
}

TEST(DocsTest, filesThatThePagesNameExist) {
    const std::regex named("`((?:src|tests|res|scripts|docs|examples|cmake)/[A-Za-z0-9_./-]+\\.[a-z]+)`");
    for (const std::string& page : pages()) {
        for (const std::string& file : allMatches(prose(readText(root() / page)), named)) {
            EXPECT_TRUE(std::filesystem::exists(root() / file)) << page << " names " << file;
        }
    }
}
