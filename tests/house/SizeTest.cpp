#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "SourceTree.h"

using namespace walkcycle::house;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

namespace {

constexpr int kLongestFunction = 45;  // lines: what fits in one look
constexpr std::size_t kLongestLoader = 300;

int numberAfter(const std::string& line, const std::string& label) {
    const std::size_t at = line.find(label);
    return at == std::string::npos ? 0 : std::atoi(line.c_str() + at + label.size());
}

bool hasCtags() {
    return outputOf("ctags --version 2>/dev/null").starts_with("Universal Ctags");
}

// "file: name has N lines" for the functions below a folder that are longer than allowed.
std::vector<std::string> longFunctions(const std::filesystem::path& folder) {
    std::vector<std::string> found;
    const std::string tags =
        outputOf("ctags -R --languages=C++ --langmap=C++:+.h --kinds-C++=f --fields=+ne -o - '" +
                 folder.string() + "' 2>/dev/null");
    for (const std::string& tag : splitLines(tags)) {
        const int lines = numberAfter(tag, "\tend:") - numberAfter(tag, "\tline:") + 1;
        if (lines <= kLongestFunction) continue;
        std::istringstream words(tag);
        std::string name, file;
        words >> name >> file;
        found.push_back(file + ": " + name + " has " + std::to_string(lines) + " lines");
    }
    return found;
}

}  // namespace

TEST(SizeTest, everyFunctionFitsInOneLook) {
    if (!hasCtags()) GTEST_SKIP() << "universal-ctags is not installed";
    EXPECT_THAT(longFunctions(root() / "src"), IsEmpty());
}

TEST(SizeTest, aFunctionThatIsTooLongIsFound) {
    if (!hasCtags()) GTEST_SKIP() << "universal-ctags is not installed";
    const auto folder = std::filesystem::path(testing::TempDir()) / "walkcycle_size_test";
    std::filesystem::create_directories(folder);
    std::string text = "int a() {\n";
    for (int i = 0; i < kLongestFunction; ++i) text += "    b();\n";
    writeText(folder / "A.cpp", text + "}\n");
    EXPECT_THAT(longFunctions(folder), SizeIs(1));
    std::filesystem::remove_all(folder);
}

TEST(SizeTest, noLoaderMustBeScrolledThrough) {
    const auto files = filesBelow("src/loaders", {".h", ".cpp"});
    ASSERT_THAT(files, Not(IsEmpty()));
    for (const std::string& file : files) {
        EXPECT_LE(splitLines(readText(root() / file)).size(), kLongestLoader) << file;
    }
}
