#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "walkcycle/model/Model.h"

namespace walkcycle {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

Joint joint(std::string id, std::string name, std::string sid) {
    Joint joint;
    joint.id = std::move(id);
    joint.name = std::move(name);
    joint.sid = std::move(sid);
    return joint;
}

// A character whose arm goes by all three names.
Model character() {
    Model model;
    model.file = "hero.dae";
    model.skeleton.joints = {joint("root", "", ""), joint("hero-arm", "Arm", "arm")};
    return model;
}

// A file with one clip, which moves a joint of these names from (0, 0, 0) to (2, 0, 0) and a parameter.
Model clipFile(Joint moved) {
    Model model;
    model.file = "run.dae";
    model.skeleton.joints = {std::move(moved)};
    Channel channel{.joint = 0};
    channel.keyFrames = {{0.0, {}}, {1.0, {.position = {2.0f, 0.0f, 0.0f}}}};
    Animation clip;
    clip.name = "run";
    clip.endSeconds = 1.0;
    clip.channels = {channel};
    clip.parameterTracks = {{.parameter = 0}};
    model.animations = {clip};
    return model;
}

TEST(BorrowedClipsTest, aJointIsFoundByIdNameOrSid) {
    for (const Joint& same :
         {joint("hero-arm", "", ""), joint("x", "Arm", ""), joint("x", "y", "arm"), joint("Arm", "", "")}) {
        const std::vector<Animation> clips = borrowClips(clipFile(same), character());
        ASSERT_THAT(clips, SizeIs(1));
        EXPECT_EQ(clips[0].name, "run");
        ASSERT_THAT(clips[0].channels, SizeIs(1));
        EXPECT_EQ(clips[0].channels[0].joint, 1);
        EXPECT_THAT(clips[0].parameterTracks, SizeIs(0)) << "weights are each file's own";
    }
}

TEST(BorrowedClipsTest, distancesAreScaledToTheModelsUnit) {
    Model source = clipFile(joint("", "Arm", ""));
    source.asset.metersPerUnit = 0.01;
    Model model = character();
    model.asset.metersPerUnit = 0.5;
    EXPECT_FLOAT_EQ(borrowClips(source, model)[0].channels[0].keyFrames[1].transform.position.x, 0.04f);
}

std::string whyNot(const Model& source) {
    try {
        borrowClips(source, character());
    } catch (const NothingToBorrow& error) {
        return error.what();
    }
    return "it was borrowed";
}

TEST(BorrowedClipsTest, whatCannotBePlayedIsRefusedWithTheReason) {
    EXPECT_THAT(whyNot(clipFile(joint("tail", "", ""))),
                testing::AllOf(HasSubstr("'run.dae' moves no joint"), HasSubstr("'hero.dae'")));
    Model still = clipFile(joint("", "Arm", ""));
    still.animations.clear();
    EXPECT_THAT(whyNot(still), HasSubstr("'run.dae' has no animation"));
}

TEST(BorrowedClipsTest, namesThatAreEmptyAreNotTheSame) {
    EXPECT_THAT(whyNot(clipFile(joint("", "", ""))), HasSubstr("moves no joint"));
}

}  // namespace
}  // namespace walkcycle
