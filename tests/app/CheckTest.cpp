#include <cstddef>
#include <fstream>
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/RunProgram.h"
#include "app/SmallDocuments.h"
#include "io/TestFolder.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class CheckTest : public testing::Test {
protected:
    std::string file(const std::string& name, const std::string& text) {
        writeFile(folder / name, bytesOf(text));
        return folder / name;
    }
    TestFolder folder;
};

TEST_F(CheckTest, checkAddsUpSeveralFilesAndGoesOnAfterOneThatCannotBeRead) {
    const std::string good = file("good.dae", liftedTriangle()), bad = file("bad.dae", damagedTriangle());
    const Ran ran = runWalkcycle({"check", good, folder / "gone.dae", bad});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(
        ran.out,
        AllOf(HasSubstr(good + ": fine\n"), HasSubstr(bad + ": 1 error, 0 warnings, 0 notes\n"),
              EndsWith("3 files, 1 fine: 2 errors, 0 warnings, 0 notes; of 1 file nothing can be shown\n")));
    EXPECT_THAT(runWalkcycle({"check", good}).out, Not(HasSubstr("files")));
    const TestFolder empty;
    const Ran both = runWalkcycle({"check", empty.path(), bad});
    EXPECT_EQ(both.exitCode, 2);
    EXPECT_THAT(both.err, AllOf(HasSubstr("holds no .dae or .zae"), HasSubstr("WC0301")));
}

TEST_F(CheckTest, checkTakesTheRulesOfOtherPrograms) {
    const std::string name = file("good.dae", liftedTriangle());
    const Ran one = runWalkcycle({"check", name, "--profile", "gazebo"});
    EXPECT_EQ(one.exitCode, 0);
    EXPECT_THAT(one.err, AllOf(HasSubstr(name + ":3: warning WC1035"), Not(HasSubstr("WC1096"))));
    const Ran two = runWalkcycle({"check", name, "--profile=gazebo", "--profile=thinmatrix", "--json"});
    EXPECT_EQ(two.exitCode, 1);
    EXPECT_THAT(two.out,
                AllOf(HasSubstr("\"WC1035\""), HasSubstr("\"WC1096\""), HasSubstr("\"profiles\": [")));
    const Ran none = runWalkcycle({"check", name, "--profile=unity"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.err, AllOf(HasSubstr("'unity'"), HasSubstr("secondlife")));
}

TEST_F(CheckTest, anIgnoredCodeMustExist) {
    const std::string name = file("bad.dae", damagedTriangle());
    EXPECT_EQ(runWalkcycle({"check", name, "--ignore", "wc0301"}).exitCode, 0);
    EXPECT_EQ(runWalkcycle({"check", name, "--ignore", "301"}).exitCode, 0);
    const Ran ran = runWalkcycle({"check", name, "--ignore", "WC0399"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("there is no message 'WC0399'"));
}

TEST_F(CheckTest, checkPrintsAnArrayForAFolder) {
    file("good.dae", liftedTriangle());
    EXPECT_THAT(runWalkcycle({"check", folder.path(), "--json"}).out, StartsWith("["));
}

TEST_F(CheckTest, theProblemMatcherFindsFileLineAndCode) {
    std::ifstream in(WALKCYCLE_SOURCE_DIR "/docs/ci/problem-matcher.json");
    const nlohmann::json matcher = nlohmann::json::parse(in)["problemMatcher"][0]["pattern"][0];
    const std::string name = file("bad.dae", damagedTriangle());
    std::string line = runWalkcycle({"check", name}).err;
    line.erase(line.find('\n'));
    std::smatch match;
    ASSERT_TRUE(std::regex_match(line, match, std::regex(matcher["regexp"].get<std::string>()))) << line;
    EXPECT_EQ(match[matcher["file"].get<std::size_t>()], name);
    EXPECT_EQ(match[matcher["line"].get<std::size_t>()], "12");
    EXPECT_EQ(match[matcher["severity"].get<std::size_t>()], "error");
    EXPECT_EQ(match[matcher["code"].get<std::size_t>()], "WC0301");
}

}  // namespace
}  // namespace walkcycle
