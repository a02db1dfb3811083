#include <string>
#include <vector>

#include "loaders/LoadText.h"
#include "loaders/curves/ChannelTarget.h"

namespace walkcycle {
namespace {

TEST(ChannelTargetTest, theNearestElementOfASidIsMeant) {
    TestLoad load(
        "<COLLADA><node id='n'><node sid='other'><scale sid='s' n='deep'/></node><scale sid='s' "
        "n='near'/></node>"
        "</COLLADA>");
    SidFinder sids;
    EXPECT_EQ(sids.find(load.byId("n"), "s").attribute("n"), "near");
    EXPECT_FALSE(sids.find(load.byId("n"), "none"));
    EXPECT_FALSE(sids.find(load.byId("n"), ""));
}

TEST(ChannelTargetTest, aSidBehindManyOthersIsFoundAsWell) {
    std::string many;
    for (int i = 0; i < 100; ++i) many += "<node sid='" + std::to_string(i) + "'><scale sid='s'/></node>";
    TestLoad load("<COLLADA><node id='n'>" + many + "<scale sid='last'/></node></COLLADA>");
    SidFinder sids;
    EXPECT_TRUE(sids.find(load.byId("n"), "last").is("scale"));
    EXPECT_EQ(sids.find(load.byId("n"), "77").line(), 1);
    EXPECT_EQ(sids.find(load.byId("n"), "s").parent().sid(), "0");
}

ChannelTarget targetOf(const TestLoad& load, const std::string& id) {
    SidFinder sids;
    return findTarget(load.byId(id), sids);
}

TEST(ChannelTargetTest, parenthesesThatAreNoIndexBelongToTheName) {
    TestLoad load(
        "<COLLADA><node id='n'><scale sid='t)'/><scale sid='t(x)'/><scale sid='t(-1)'/><scale "
        "sid='t'/></node>"
        "<channel id='a' target='n/t)'/><channel id='b' target='n/t(x)'/><channel id='c' target='n/t(-1)'/>"
        "<channel id='d' target='n/t(1)(2)(3)'/><channel id='e' target='#n/t(1)(2)'/></COLLADA>");
    EXPECT_EQ(targetOf(load, "a").element.sid(), "t)");
    EXPECT_EQ(targetOf(load, "b").element.sid(), "t(x)");
    EXPECT_EQ(targetOf(load, "c").element.sid(), "t(-1)");
    EXPECT_FALSE(targetOf(load, "d").element) << "nothing has three indices";
    EXPECT_EQ(targetOf(load, "e").element.sid(), "t");
    EXPECT_EQ(targetOf(load, "e").indices, (std::vector<int>{1, 2}));
}

TEST(ChannelTargetTest, whatWasLookedForIsTheFirstSidThatIsMissing) {
    TestLoad load(
        "<COLLADA><node id='n'/><channel id='a' target='n/arm/hand/t.X'/><channel id='b' target='n/t.X'/>"
        "</COLLADA>");
    EXPECT_EQ(targetOf(load, "a").lookedFor, "sid 'arm' below <node>");
    EXPECT_EQ(targetOf(load, "b").lookedFor, "sid 't' below <node>");
}

}  // namespace
}  // namespace walkcycle
