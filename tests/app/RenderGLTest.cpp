#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/RunProgram.h"
#include "app/SmallDocuments.h"
#include "io/ImageDecoder.h"
#include "io/TestFolder.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

// `walkcycle render` as a whole: what it writes, and where.
class RenderGLTest : public testing::Test {
protected:
    RenderGLTest() { writeFile(document, bytesOf(liftedTriangle())); }

    Ran render(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"render", document, "--resolution", "64,48"});
        return runWalkcycle(arguments);
    }
    Image picture(const std::string& name) { return decodeImage(readFile(folder / name, 1 << 24)); }

    TestFolder folder;
    std::string document = folder / "lift.dae";
};

int covered(const Image& image) {
    int pixels = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) pixels += image.rgba[i] > 127;
    return pixels;
}

TEST_F(RenderGLTest, aPictureHasTheSizeAskedForAndShowsTheModel) {
    const Ran ran = render({"-o", folder / "out.png", "--no-background"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, IsEmpty());
    const Image image = picture("out.png");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 48);
    EXPECT_TRUE(image.hasAlpha);
    EXPECT_GT(covered(image), 50);
    EXPECT_LT(covered(image), 64 * 48 / 2);
}

TEST_F(RenderGLTest, twoRunsGiveTheSameBytes) {
    const Ran once = render({"-o", "-"}), again = render({"-o", "-"});
    ASSERT_EQ(once.exitCode, 0) << once.err;
    EXPECT_FALSE(once.out.empty());
    EXPECT_EQ(once.out, again.out);
}

TEST_F(RenderGLTest, severalTimesGiveNumberedPicturesThatDiffer) {
    ASSERT_EQ(render({"-o", folder / "at_{frame:02}.png", "--time", "0,0.5,1", "--camera", "front"}).exitCode,
              0);
    EXPECT_NE(picture("at_00.png").rgba, picture("at_01.png").rgba);
    EXPECT_NE(picture("at_01.png").rgba, picture("at_02.png").rgba);
    EXPECT_EQ(folder.fileCount(), 4u);
    const Ran oneName = render({"-o", folder / "at.png", "--time", "0,0.5"});
    EXPECT_EQ(oneName.exitCode, 2);
    EXPECT_THAT(oneName.err, HasSubstr("{frame}"));
}

TEST_F(RenderGLTest, framesAreTimesAtTheirRate) {
    ASSERT_EQ(
        render({"-o", folder / "f{frame}.png", "--frames", "5..6", "--fps", "10", "--camera=front"}).exitCode,
        0);
    ASSERT_EQ(render({"-o", folder / "t.png", "--time", "0.6", "--camera=front"}).exitCode, 0);
    EXPECT_EQ(picture("f1.png").rgba, picture("t.png").rgba);
}

TEST_F(RenderGLTest, aTurntableGoesRoundAndASheetHoldsAllInOnePicture) {
    ASSERT_EQ(render({"-o", folder / "t{frame}.png", "--turntable", "2"}).exitCode, 0);
    EXPECT_NE(picture("t0.png").rgba, picture("t1.png").rgba);
    ASSERT_EQ(render({"-o", folder / "sheet.webp", "--sheet", "2x2"}).exitCode, 0);
    EXPECT_EQ(picture("sheet.webp").width, 64);
}

TEST_F(RenderGLTest, aCameraOfTheFileIsFoundByItsNodeOrItsOwnName) {
    ASSERT_EQ(render({"-o", folder / "node.png", "--camera", "front"}).exitCode, 0);
    ASSERT_EQ(render({"-o", folder / "lens.png", "--camera", "lens"}).exitCode, 0);
    ASSERT_EQ(render({"-o", folder / "side.png", "--camera", "side"}).exitCode, 0);
    EXPECT_EQ(picture("node.png").rgba, picture("lens.png").rgba);
    EXPECT_NE(picture("node.png").rgba, picture("side.png").rgba);
    const Ran unknown = render({"-o", folder / "x.png", "--camera", "Hitchcock"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, AllOf(HasSubstr("'Hitchcock'"), HasSubstr("'front'"), HasSubstr("iso")));
}

TEST_F(RenderGLTest, aPlaceOfOnesOwnSeesWhatAFileCameraThereSees) {
    ASSERT_EQ(runWalkcycle({"render", document, "-o", folder / "file.png", "--no-background",
                            "--resolution=48,48", "--camera=front"})
                  .exitCode,
              0);
    ASSERT_EQ(runWalkcycle({"render", document, "-o", folder / "own.png", "--no-background",
                            "--resolution=48,48", "--camera-position", "0.3,0.5,6", "--camera-focal-point",
                            "0.3,0.5,0", "--camera-view-angle", "45"})
                  .exitCode,
              0);
    EXPECT_EQ(picture("file.png").rgba, picture("own.png").rgba);
}

TEST_F(RenderGLTest, aBackgroundIsTheColourNamed) {
    ASSERT_EQ(render({"-o", folder / "out.png", "--background", "#4080c0", "--no-grid"}).exitCode, 0);
    const Image image = picture("out.png");
    EXPECT_FALSE(image.hasAlpha);
    EXPECT_THAT(std::vector<int>(image.rgba.begin(), image.rgba.begin() + 3),
                testing::ElementsAre(0x40, 0x80, 0xC0));
}

TEST_F(RenderGLTest, compareMeasuresPictures) {
    ASSERT_EQ(render({"-o", folder / "a.png"}).exitCode, 0);
    ASSERT_EQ(render({"-o", folder / "b.png", "--time", "1"}).exitCode, 0);
    const Ran same = runWalkcycle({"compare", folder / "a.png", folder / "a.png", "--metric", "ssim"});
    EXPECT_EQ(same.exitCode, 0);
    EXPECT_EQ(same.out, "1\n");
    EXPECT_EQ(runWalkcycle({"compare", folder / "a.png", folder / "a.png", "--metric=psnr"}).out, "inf\n");
    const Ran different =
        runWalkcycle({"compare", folder / "a.png", folder / "b.png", "-o", folder / "diff.png"});
    EXPECT_EQ(different.exitCode, 1);
    EXPECT_EQ(picture("diff.png").width, 64);
    EXPECT_EQ(runWalkcycle({"compare", folder / "a.png", folder / "b.png", "--threshold", "1"}).exitCode, 0);
    EXPECT_EQ(runWalkcycle({"compare", folder / "a.png", document}).exitCode, 2) << "no picture";
}

TEST_F(RenderGLTest, theLastFileStaysWhereAPictureCannotBeWritten) {
    const Ran ran = render({"-o", folder / "missing/out.png"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_EQ(folder.fileCount(), 1u);
}

TEST_F(RenderGLTest, interruptedInTheMiddleOfAFilmItLeavesOnlyWholePictures) {
    const Ran ran = runWalkcycle({"render", document, "-o", folder / "f{frame}.png", "--frames", "0..100000"},
                                 "", {}, {"/usr/bin/timeout", "--preserve-status", "--signal=INT", "2"});
    EXPECT_EQ(ran.exitCode, 130);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        const std::string name = entry.path().filename().string();
        if (name == "lift.dae") continue;
        ASSERT_TRUE(name.starts_with("f") && name.ends_with(".png")) << name;
        EXPECT_EQ(picture(name).width, 1280);
    }
}

}  // namespace
}  // namespace walkcycle
