#include "LoadText.h"
#include "loaders/ChannelTarget.h"

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

}  // namespace
}  // namespace walkcycle
