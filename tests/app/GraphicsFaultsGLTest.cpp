#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/Faults.h"
#include "app/SmallDocuments.h"
#include "io/ImageDecoder.h"

namespace walkcycle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class GraphicsFaultsGLTest : public testing::Test {
protected:
    GraphicsFaultsGLTest() { writeFile(document, bytesOf(liftedTriangle())); }
    TestFolder folder, output;
    std::string document = folder / "lift.dae";
};

// Drivers may say more, but we say one line.
std::string ownLines(const std::string& text) {
    std::string own;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size() - 1) + 1;
        if (text.compare(start, 10, "walkcycle:") == 0) own += text.substr(start, end - start);
        start = end;
    }
    return own;
}

TEST_F(GraphicsFaultsGLTest, withoutADeviceThatDrawsItSaysSoAndEndsWithThree) {
    using Environment = std::map<std::string, std::string>;
    const Environment noDisplay = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};
    for (Environment environment :
         {Environment{{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"}},
          Environment{{"LIBGL_DRIVERS_PATH", "/nonexistent"}},
          Environment{{"MESA_GL_VERSION_OVERRIDE", "2.1"}}, Environment{{"MESA_GL_VERSION_OVERRIDE", "3.2"}},
          Environment{{"MESA_GLSL_VERSION_OVERRIDE", "120"}}}) {
        const std::string name = testing::PrintToString(environment);
        environment.insert(noDisplay.begin(), noDisplay.end());
        const Ran ran = runWalkcycle({"render", document, "-o", output / "out.png"}, "", environment);
        EXPECT_EQ(ran.exitCode, 3) << name << ran.err;
        EXPECT_THAT(ownLines(ran.err), HasSubstr("walkcycle: error: no graphics device")) << name;
        EXPECT_EQ(linesOf(ownLines(ran.err)), 1) << name << ran.err;
    }
    EXPECT_EQ(output.fileCount(), 0u);
}

TEST_F(GraphicsFaultsGLTest, aDisplayThatIsNotThereEndsWithThree) {
    const std::map<std::string, std::string> gone = {{"DISPLAY", ":4711"}, {"WAYLAND_DISPLAY", ""}};
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"view", document},
          {"render", document, "-o", output / "out.png", "--backend", "glfw"}}) {
        const Ran ran = runWalkcycle(command, "", gone);
        EXPECT_EQ(ran.exitCode, 3) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("no display to open a window on"));
        EXPECT_EQ(linesOf(ownLines(ran.err)), 1) << ran.err;
    }
    EXPECT_EQ(output.fileCount(), 0u);
}

TEST_F(GraphicsFaultsGLTest, aPictureThatCannotBeWrittenLeavesTheFolderAsItWas) {
    for (const auto& [wrapper, reason] :
         {std::pair(std::vector<std::string>{"/usr/bin/prlimit", "--fsize=100"}, "File too large"),
          std::pair(shell(">&-"), "Bad file descriptor")}) {
        const bool toStandardOutput = wrapper.front() == "/bin/sh";
        const Ran ran = runWalkcycle(
            {"render", document, "--resolution=64,48", "-o", toStandardOutput ? "-" : output / "out.png"}, "",
            {{"MESA_SHADER_CACHE_DISABLE", "true"}}, wrapper);
        EXPECT_EQ(ran.exitCode, 2) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr(reason));
    }
    EXPECT_EQ(output.fileCount(), 0u);
}

TEST_F(GraphicsFaultsGLTest, aFilmThatIsTerminatedLeavesOnlyWholePictures) {
    for (const auto& [signal, exitCode] :
         {std::pair("INT", 130), std::pair("TERM", 143), std::pair("HUP", 129)}) {
        const TestFolder film;
        const Ran ran = runWalkcycle(
            {"render", document, "-o", film / "f{frame}.png", "--frames", "0..100000",
             "--resolution=160,120"},
            "", {}, {"/usr/bin/timeout", "--preserve-status", std::string("--signal=") + signal, "2"});
        EXPECT_EQ(ran.exitCode, exitCode);
        for (const auto& entry : std::filesystem::directory_iterator(film.path())) {
            ASSERT_EQ(entry.path().extension(), ".png") << entry.path();
            EXPECT_EQ(decodeImage(readFile(entry.path().string(), 1 << 24)).width, 160);
        }
    }
}

}  // namespace
}  // namespace walkcycle
