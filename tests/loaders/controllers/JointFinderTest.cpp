#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/controllers/JointFinder.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Two arms with joints of the same sids, a mesh node in each chain, and a rig that no scene shows.
constexpr const char* kArms = R"(<COLLADA>
<library_nodes><node id="rig" sid="rig"><node id="rig-toe" sid="toe"/></node></library_nodes>
<visual_scene id="scene">
  <node id="left" name="Left"><node id="left-hand" sid="hand" name="Hand L"/><node id="left-mesh"/></node>
  <node id="right"><node id="right-hand" sid="hand"/><node id="right-mesh"/></node>
  <node id="hand" sid="head"/>
</visual_scene>
<instance_controller id="plain"/>
<instance_controller id="toRight"><skeleton> #right
</skeleton></instance_controller>
<instance_controller id="toBoth"><skeleton>#left</skeleton><skeleton>#right</skeleton></instance_controller>
<instance_controller id="toScene"><skeleton>#scene</skeleton></instance_controller>
<instance_controller id="toRig"><skeleton>#rig</skeleton></instance_controller>
<instance_controller id="astray">
<skeleton>#gone</skeleton></instance_controller>
</COLLADA>)";

class JointFinderTest : public ::testing::Test {
protected:
    JointFinderTest() { skeletons.addScene(load.byId("scene")); }

    int joint(std::string_view id) {
        const auto found = skeletons.scene().occurrences.find(load.byId(id));
        return found == skeletons.scene().occurrences.end() ? kNoParent : found->second;
    }
    std::string idOf(int index) {
        return index == kNoParent ? "none"
                                  : skeletons.scene().skeleton.joints[static_cast<std::size_t>(index)].id;
    }
    std::string find(std::string_view name, bool isId, std::string_view instance,
                     std::string_view node = "left-mesh") {
        return idOf(
            finder.find(name, isId, finder.skeletonRoots(load.byId(instance)), joint(node), load.collada));
    }

    TestLoad load{kArms};
    Asset asset;
    SkeletonLoader skeletons{load.context, asset, load.collada};
    JointFinder finder{load.context, skeletons};
};

TEST_F(JointFinderTest, theSkeletonTellsJointsOfOneNameApart) {
    EXPECT_EQ(find("hand", false, "toRight"), "right-hand");
}

TEST_F(JointFinderTest, withoutASkeletonTheNearestJointIsMeant) {
    EXPECT_EQ(find("hand", false, "plain", "left-mesh"), "left-hand");
    EXPECT_EQ(find("hand", false, "plain", "right-mesh"), "right-hand");
}

TEST_F(JointFinderTest, severalSkeletonsAreAllLookedThrough) {
    EXPECT_EQ(find("hand", false, "toBoth", "right-mesh"), "right-hand");
    EXPECT_EQ(find("left", true, "toBoth"), "left");
}

TEST_F(JointFinderTest, aSkeletonThatNamesTheSceneMeansAllOfIt) {
    EXPECT_THAT(finder.skeletonRoots(load.byId("toScene")), IsEmpty());
    EXPECT_EQ(find("head", false, "toScene"), "hand");
    EXPECT_THAT(load.diagnostics.all(), IsEmpty());
}

TEST_F(JointFinderTest, aSkeletonThatIsNotThereIsReportedAndJointsAreLookedForEverywhere) {
    EXPECT_EQ(find("head", false, "astray"), "hand");
    EXPECT_THAT(load.diagnostics.all(),
                ElementsAre(says("WC0413", 15, "COLLADA/instance_controller[id=astray]/skeleton")));
}

TEST_F(JointFinderTest, namesAreSidsAndIdrefsAreIds) {
    EXPECT_EQ(find("hand", true, "plain"), "hand");
    EXPECT_NE(find("hand", false, "plain"), "hand");
}

TEST_F(JointFinderTest, asACourtesyAnIdOrANameWillDo) {
    EXPECT_EQ(find("left-hand", false, "plain"), "left-hand");
    EXPECT_EQ(find("head", true, "plain"), "hand");
    EXPECT_EQ(find("Left", false, "plain"), "left");
    EXPECT_EQ(find("Hand L", false, "plain"), "left-hand");
}

TEST_F(JointFinderTest, aJointOutsideTheSkeletonIsFoundAllTheSame) {
    EXPECT_EQ(find("head", false, "toRight"), "hand");
}

TEST_F(JointFinderTest, jointsThatNoSceneShowsAreFetched) {
    const std::size_t before = skeletons.scene().skeleton.joints.size();
    EXPECT_EQ(find("toe", false, "toRig"), "rig-toe");
    EXPECT_EQ(skeletons.scene().skeleton.joints.size(), before + 2);
    EXPECT_FALSE(skeletons.scene().drawn.back());
    EXPECT_EQ(find("rig-toe", true, "plain"), "rig-toe");
    EXPECT_EQ(skeletons.scene().skeleton.joints.size(), before + 2) << "once only";
}

TEST_F(JointFinderTest, anIdInTheLibraryIsFetchedWithItsWholeTree) {
    EXPECT_EQ(find("rig-toe", true, "plain"), "rig-toe");
    EXPECT_EQ(idOf(skeletons.scene().skeleton.joints.back().parent), "rig");
}

TEST_F(JointFinderTest, whatIsNowhereIsNoJoint) {
    EXPECT_EQ(find("tail", false, "plain"), "none");
    EXPECT_EQ(find("plain", true, "plain"), "none") << "an id of another kind of element";
    EXPECT_EQ(find("", false, "plain"), "none");
}

TEST_F(JointFinderTest, nodesMeetAtTheirNearestCommonAncestor) {
    EXPECT_EQ(finder.nearestCommonAncestor(joint("left-hand"), joint("left-mesh")), joint("left"));
    EXPECT_EQ(finder.nearestCommonAncestor(joint("left"), joint("left-mesh")), joint("left"));
    EXPECT_EQ(finder.nearestCommonAncestor(joint("left-hand"), joint("right-hand")), kNoParent);
    EXPECT_EQ(finder.nearestCommonAncestor(kNoParent, joint("left")), kNoParent);
}

TEST(JointFinderInstancesTest, ofTheOccurrencesOfASkeletonOneIsMeantAndAlwaysTheSame) {
    TestLoad load(
        "<COLLADA><library_nodes><node id='rig'><node id='toe' sid='toe'/></node></library_nodes>"
        "<visual_scene id='scene'><node id='a'><instance_node url='#rig'/><node id='mesh'/></node>"
        "<node id='b'><node id='deep'><instance_node url='#rig'/></node></node></visual_scene>"
        "<instance_controller id='to'><skeleton>#rig</skeleton></instance_controller></COLLADA>");
    Asset asset;
    SkeletonLoader skeletons(load.context, asset, load.collada);
    skeletons.addScene(load.byId("scene"));
    JointFinder finder(load.context, skeletons);
    const std::vector<int> roots = finder.skeletonRoots(load.byId("to"));
    ASSERT_EQ(roots.size(), 1u);
    EXPECT_EQ(roots[0], 1) << "the first in the order of the file";
    EXPECT_EQ(finder.find("toe", false, roots, 3, load.collada), 2);
}

}  // namespace
}  // namespace walkcycle
