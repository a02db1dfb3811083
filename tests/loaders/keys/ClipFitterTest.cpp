#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"

namespace walkcycle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const std::string kMove = "<translate sid='t'>0 0 0</translate>";
const std::string kRotate = "<rotate sid='r'>0 0 1 0</rotate>";

LoadOptions within(double tolerance) {
    LoadOptions options;
    options.tolerance = tolerance;
    options.loadImages = false;
    return options;
}

// Loads with ever smaller tolerances. `load(options)` gives the model.
template <typename Load>
void expectErrorNeverRises(const std::vector<double>& tolerances, const Load& load) {
    std::vector<float> before;
    for (const double tolerance : tolerances) {
        SCOPED_TRACE(tolerance);
        const Model model = load(within(tolerance));
        float most = 0.0f;
        for (std::size_t i = 0; i < model.animations.size(); ++i) {
            const float error = model.animations[i].achievedError;
            most = std::max(most, error);
            if (i < before.size()) {
                EXPECT_LE(error, before[i]) << model.animations[i].name;
                before[i] = error;
            } else {
                before.push_back(error);
            }
        }
        if (most > tolerance) {
            EXPECT_THAT(codes(model.diagnostics), Contains("WC0513"));
        } else {
            EXPECT_THAT(codes(model.diagnostics), Not(Contains("WC0513")));
        }
    }
}

const std::vector<double> kDecades{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

TEST(ClipFitterTest, aSmallerToleranceNeverGivesALargerErrorWhateverTheFile) {
    std::vector<std::filesystem::path> files;
    for (const char* folder : {WALKCYCLE_FIXTURES, WALKCYCLE_SOURCE_DIR "/res"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".dae") files.push_back(entry.path());
    EXPECT_GE(files.size(), 9u);
    for (const std::filesystem::path& file : files) {
        SCOPED_TRACE(file.string());
        try {
            expectErrorNeverRises(
                kDecades, [&](const LoadOptions& options) { return loadCollada(file.string(), options); });
        } catch (const LoadError&) {
            continue;  // a fixture without a scene
        }
    }
}

// A curve that is no cubic, two rotations at once, shear as exporters round it in, and a joint too fast for any keys.
TEST(ClipFitterTest, aSmallerToleranceNeverGivesALargerErrorWhateverMoves) {
    AnimationText swing{.target = "box/r.ANGLE",
                        .times = "0 1 1.2 3",
                        .values = "0 80 -60 5",
                        .interpolations = "CARDINAL",
                        .id = "swing"};
    AnimationText tilt{.target = "box/y.ANGLE", .times = "0 3", .values = "0 500", .id = "tilt"};
    AnimationText fast{.target = "box/r.ANGLE", .times = "0 1", .values = "0 36000000"};
    AnimationText sheared{.target = "box/m",
                          .times = "0 1 2",
                          .values =
                              "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1  0.000003 -1 0 2 1 0 0 0 0 0 1 0 0 0 0 1 "
                              "-1 0 0 4 0.00001 -1 0 0 0 0 1 0 0 0 0 1",
                          .params = "M"};
    const std::string stack = kRotate + "<rotate sid='y'>0 1 0 0</rotate>";
    for (const std::string& text :
         {boxWith(stack, animations(swing.text())), boxWith(stack, animations(swing.text() + tilt.text())),
          boxWith(stack, animations(fast.text() + tilt.text())),
          boxWith("<matrix sid='m'>" + kIdentity + "</matrix>", animations(sheared.text()))}) {
        SCOPED_TRACE(text);
        expectErrorNeverRises({0.3, 1e-2, 5e-3, 2e-3, 1e-3, 2e-4, 1e-4, 7e-5, 3e-5, 1e-5, 1e-6, 1e-7, 1e-9},
                              [&](const LoadOptions& options) { return loadText(text, options); });
    }
}

// Joints that rotate so fast about two axes that together they need more spare keys than a clip may have.
TEST(ClipFitterTest, jointsThatNeedMoreKeysThanThereAreGetLikeShares) {
    constexpr int kJoints = 14;
    std::string nodes, channels;
    for (int i = 0; i < kJoints; ++i) {
        const std::string name = "n" + std::to_string(i);
        nodes += "<node id='" + name + "'><rotate sid='r'>0 0 1 0</rotate><rotate sid='y'>0 1 0 0</rotate>" +
                 "<instance_geometry url='#mesh'/></node>";
        for (const std::string sid : {"r", "y"})
            channels += AnimationText{.target = name + "/" + sid + ".ANGLE",
                                      .times = "0 1",
                                      .values = sid == "r" ? "0 130000" : "0 91000",
                                      .id = name + sid}
                            .text();
    }
    const Model model = loadText(collada(triangle() + animations(channels) + scene(nodes)));
    ASSERT_THAT(model.animations.at(0).channels, SizeIs(kJoints));
    for (const Channel& channel : model.animations[0].channels)
        EXPECT_GT(channel.keyFrames.size(), 2000u) << "of " << channel.joint;
    EXPECT_LT(model.animations[0].achievedError, 1e-3f);
}

TEST(ClipFitterTest, whatIsMissedIsSaidInNumbersThatCanBeRead) {
    const Model model = loadText(
        boxWith(kRotate, animations(AnimationText{"box/r.ANGLE", "0 1 2", "0 33 71"}.text())), within(1e-9));
    ASSERT_THAT(codes(model.diagnostics), ElementsAre("WC0513"));
    EXPECT_THAT(model.diagnostics[0].message, HasSubstr("e-0"));
}

TEST(ClipFitterTest, aFileThatLoadsIsNotRefusedWithASmallerToleranceForItsKeyFrames) {
    const AnimationText swing{
        .target = "box/r.ANGLE", .times = "0 1 1.2 3", .values = "0 80 -60 5", .interpolations = "CARDINAL"};
    const std::string text = boxWith(kRotate, animations(swing.text()));
    LoadOptions fine = within(1e-7);
    fine.limits.maxKeyFrames = loadText(text).animations.at(0).channels.at(0).keyFrames.size();
    const Model model = loadText(text, fine);
    EXPECT_LE(model.animations.at(0).channels.at(0).keyFrames.size(), fine.limits.maxKeyFrames);
    EXPECT_LE(model.animations[0].achievedError, 1e-4f);
    EXPECT_THAT(codes(model.diagnostics), ElementsAre("WC0513"));
}

TEST(ClipFitterTest, aFileWithTooManyKeyFramesLoadsWithALargerTolerance) {
    const AnimationText zigzag{"box/t.X", "0 1 2 3 4 5 6", "0 0.01 0 0.01 0 0.01 0"};
    const std::string text = boxWith(kMove, animations(zigzag.text()));
    LoadOptions coarse = within(1e-2);
    coarse.limits.maxKeyFrames = 3;
    EXPECT_THAT(loadText(text, coarse).animations.at(0).channels.at(0).keyFrames, SizeIs(2));
    LoadOptions fine = within(1e-4);
    fine.limits.maxKeyFrames = 3;
    EXPECT_EQ(whyNot(text, fine).code, "WC0801");
}

// ---- clips

const AnimationText kX{.target = "box/t.X", .times = "0 1 2 3 4", .values = "0 4 0 4 0", .id = "x"};
const AnimationText kY{.target = "box/t.Y", .times = "0 4", .values = "0 8", .id = "y"};

Model withClips(const std::string& body, const std::string& clips) {
    return loadText(boxWith(
        kMove, animations(body) + "<library_animation_clips>" + clips + "</library_animation_clips>"));
}

std::string clip(const std::string& attributes, const std::string& url) {
    return "<animation_clip " + attributes + "><instance_animation url='" + url + "'/></animation_clip>";
}

TEST(ClipFitterTest, aClipOfAllThatMovesIsCutOutOfTheWhole) {
    const Model model = withClips(kX.text(), clip("id='middle' start='1.25' end='2.5'", "#x"));
    ASSERT_THAT(model.animations, SizeIs(2));
    const std::vector<KeyFrame>& keys = model.animations[1].channels.at(0).keyFrames;
    ASSERT_THAT(keys, SizeIs(3));  // the last before it, the first after it, and what is between
    EXPECT_EQ(keys[0].seconds, 1.0);
    EXPECT_EQ(keys[1].seconds, 2.0);
    EXPECT_EQ(keys[2].seconds, 3.0);
    EXPECT_EQ(model.animations[1].achievedError, model.animations[0].achievedError);
}

TEST(ClipFitterTest, aClipThatEndsAtAKeyNeedsNoneBehindIt) {
    const Model model = withClips(kX.text(), clip("id='first' start='1' end='2'", "#x"));
    const std::vector<KeyFrame>& keys = model.animations.at(1).channels.at(0).keyFrames;
    ASSERT_THAT(keys, SizeIs(2));
    EXPECT_EQ(keys[0].seconds, 1.0);
    EXPECT_EQ(keys[1].seconds, 2.0);
}

TEST(ClipFitterTest, aClipOfSomeChannelsOfAJointHasKeysOfItsOwn) {
    const Model model = withClips(kX.text() + kY.text(), clip("id='rise'", "#y") + clip("id='sway'", "#x"));
    ASSERT_THAT(model.animations, SizeIs(3));
    EXPECT_THAT(model.animations[0].channels.at(0).keyFrames, SizeIs(5));
    EXPECT_THAT(model.animations[1].channels.at(0).keyFrames, SizeIs(2));
    EXPECT_NEAR(keyed(model, 1.0, 0, 1)[3].y, 2.0f, 1e-4f);
    EXPECT_NEAR(keyed(model, 1.0, 0, 1)[3].x, 0.0f, 1e-4f);
    EXPECT_NEAR(keyed(model, 1.0, 0, 2)[3].x, 4.0f, 1e-4f);
    EXPECT_LT(model.animations[1].achievedError, 1e-6f);
}

TEST(ClipFitterTest, aClipInWhichNothingMovesIsLeftOut) {
    const AnimationText nowhere{.target = "gone/t.X", .times = "0 1", .values = "0 1", .id = "nowhere"};
    const Model model =
        withClips(kX.text() + nowhere.text(), clip("id='none'", "#nowhere") + clip("id='sway'", "#x"));
    ASSERT_THAT(model.animations, SizeIs(2));
    EXPECT_EQ(model.animations[1].name, "sway");
}

}  // namespace
}  // namespace walkcycle
