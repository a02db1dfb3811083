#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "app/RunProgram.h"
#include "io/TestFolder.h"

// The same file gives the same bytes, wherever and however the program runs.
namespace walkcycle {
namespace {

class DeterminismGLTest : public testing::Test {
protected:
    // A moment of the built-in character as PNG.
    static std::string walk(const std::map<std::string, std::string>& environment = {},
                            const std::vector<std::string>& wrapper = {}) {
        const Ran ran = runWalkcycle({"render", WALKCYCLE_SOURCE_DIR "/res/walker.dae", "--time", "0.4",
                                      "--resolution", "160,120", "-o", "-"},
                                     "", environment, wrapper);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_GT(ran.out.size(), 1000u);
        return ran.out;
    }
    static const std::string& once() {
        static const std::string picture = walk();
        return picture;
    }
};

TEST_F(DeterminismGLTest, onRepeat) {
    EXPECT_TRUE(walk() == once());
}

TEST_F(DeterminismGLTest, fromAnyWorkingDirectory) {
    const TestFolder elsewhere;
    EXPECT_TRUE(walk({}, {"/usr/bin/env", "-C", elsewhere / ""}) == once());
}

TEST_F(DeterminismGLTest, underALocaleWithDecimalCommas) {
    EXPECT_TRUE(walk({{"LC_ALL", "de_DE.UTF-8"}}) == once());
}

TEST_F(DeterminismGLTest, withAnyNumberOfThreads) {
    for (const char* threads : {"0", "1", "2", "7"})
        EXPECT_TRUE(walk({{"LP_NUM_THREADS", threads}}) == once()) << threads;
}

TEST_F(DeterminismGLTest, posesAreTheSameTextUnderAnyLocale) {
    const std::vector<std::string> pose = {"pose", WALKCYCLE_SOURCE_DIR "/res/walker.dae", "--time",
                                           "0.1,0.7", "--json"};
    const Ran plain = runWalkcycle(pose), german = runWalkcycle(pose, "", {{"LC_ALL", "de_DE.UTF-8"}});
    ASSERT_EQ(plain.exitCode, 0) << plain.err;
    EXPECT_TRUE(plain.out == german.out);
}

}  // namespace
}  // namespace walkcycle
