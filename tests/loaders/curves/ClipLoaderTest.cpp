#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "loaders/AnimationText.h"
#include "loaders/curves/ClipLoader.h"

namespace walkcycle {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const AnimationText kX{.target = "box/t.X", .times = "0 1 2", .values = "0 4 0", .id = "x"};
const AnimationText kY{.target = "box/t.X", .times = "0 2", .values = "0 8", .id = "y"};

std::string withClips(const std::string& body, const std::string& clips) {
    return boxWith("<translate sid='t'>0 0 0</translate>",
                   animations(body) + "\n<library_animation_clips>\n" + clips + "</library_animation_clips>");
}

std::string clip(const std::string& attributes, const std::string& url) {
    return "<animation_clip " + attributes + "><instance_animation url='" + url + "'/></animation_clip>\n";
}

TEST(ClipLoaderTest, channelsOfOneTargetInClipsOfTheirOwnAreNoRivals) {
    const std::string body = kX.text() + kY.text();
    const Model apart = loadText(withClips(body, clip("id='walk'", "#x") + clip("id='run'", "#y")));
    EXPECT_THAT(codes(apart.diagnostics), Not(Contains("WC0511")));
    ASSERT_THAT(apart.animations, SizeIs(3));
    EXPECT_NEAR(keyed(apart, 1.0, 0, 1)[3].x, 4.0f, 1e-3f);
    EXPECT_NEAR(keyed(apart, 0.5, 0, 2)[3].x, 2.0f, 1e-3f);
    const std::string both =
        "<animation_clip id='all'><instance_animation url='#x'/><instance_animation url='#y'/>"
        "</animation_clip>";
    EXPECT_THAT(codes(loadText(withClips(body, both)).diagnostics), Contains("WC0511"));
    // What no clip plays is played by the whole timeline only, all together.
    const AnimationText other{.target = "box/t.Y", .times = "0 2", .values = "0 8", .id = "z"};
    EXPECT_THAT(codes(loadText(withClips(body + other.text(), clip("id='rise'", "#z"))).diagnostics),
                Contains("WC0511"));
}

TEST(ClipLoaderTest, aClipWithoutAnyNameIsCounted) {
    const Model model = loadText(withClips(kX.text(), clip("", "#x") + clip("", "#x")));
    ASSERT_THAT(model.animations, SizeIs(3));
    EXPECT_EQ(model.animations[1].name, "clip 1");
    EXPECT_EQ(model.animations[2].name, "clip 2");
}

TEST(ClipLoaderTest, aTimeThatIsNoNumberIsReportedAndTheKeysSayWhen) {
    const std::string text = withClips(kX.text(), clip("id='walk' start='0.5' end='soon'", "#x"));
    const Model model = loadText(text);
    ASSERT_THAT(codes(model.diagnostics), ElementsAre("WC0512"));
    EXPECT_EQ(model.diagnostics[0].line, lineOf(text, "<animation_clip "));
    EXPECT_THAT(model.diagnostics[0].message, HasSubstr("no usable end"));
    EXPECT_DOUBLE_EQ(model.animations.at(1).startSeconds, 0.5);
    EXPECT_DOUBLE_EQ(model.animations.at(1).endSeconds, 2.0);
}

TEST(ClipLoaderTest, aClipOfAnAnimationThatIsEmptyOrElsewhereIsNotPlayed) {
    const Model empty = loadText(withClips(kX.text() + "<animation id='none'/>", clip("id='walk'", "#none")));
    EXPECT_THAT(empty.animations, SizeIs(1)) << "nothing moves in it";
    std::string stray = withClips(kX.text(), clip("id='walk'", "#stray"));
    stray.insert(stray.find("<library_animation_clips>"),
                 "<extra><technique profile='p'><animation id='stray'/></technique></extra>");
    const Model model = loadText(stray);
    EXPECT_THAT(codes(model.diagnostics), Contains("WC0512"));
    const Model gone = loadText(withClips(kX.text(), clip("id='walk'", "#gone")));
    EXPECT_THAT(codes(gone.diagnostics), ElementsAre("WC0201", "WC0512"));
}

TEST(ClipLoaderTest, aClipPlaysTheKeysAboutItsTimes) {
    const AnimationText steps{
        .target = "box/t.X", .times = "0 1 1 2 3 3 4", .values = "0 1 5 6 7 9 10", .id = "x"};
    const Model model = loadText(withClips(steps.text(), clip("id='a' start='-1' end='3'", "#x") +
                                                             clip("id='b' start='1' end='3'", "#x") +
                                                             clip("id='c' start='9' end='12'", "#x")));
    ASSERT_THAT(model.animations, SizeIs(4));
    EXPECT_NEAR(keyed(model, -1.0, 0, 1)[3].x, 0.0f, 1e-3f);
    EXPECT_NEAR(keyed(model, 0.5, 0, 1)[3].x, 0.5f, 1e-3f);
    EXPECT_NEAR(keyed(model, 1.0, 0, 2)[3].x, 5.0f, 1e-3f);
    EXPECT_NEAR(keyed(model, 3.0, 0, 2)[3].x, 9.0f, 1e-3f);
    EXPECT_NEAR(keyed(model, 10.0, 0, 3)[3].x, 10.0f, 1e-3f);
}

TEST(ClipLoaderTest, theTimelineIsNamedAfterAFileWhateverThatIsCalled) {
    for (const auto& [file, name] :
         {std::pair(".walk", ".walk"), std::pair("walk", "walk"), std::pair("a.b/walk.dae", "walk"),
          std::pair("c:\\walk.x.dae", "walk.x")}) {
        const Model model = loadCollada(bytesOf(withClips(kX.text(), "")), file);
        EXPECT_EQ(model.animations.at(0).name, name) << file;
    }
}

}  // namespace
}  // namespace walkcycle
