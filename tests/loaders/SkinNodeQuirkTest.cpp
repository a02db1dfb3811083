#include <gtest/gtest.h>

#include "loaders/SkinNodeQuirk.h"

namespace walkcycle {
namespace {

TEST(SkinNodeQuirkTest, theToolDecidesUnlessTheUserDoes) {
    EXPECT_TRUE(nodePlacesSkin("Maya 8.5 | ColladaMaya v3.03b", SkinNode::Auto));
    EXPECT_TRUE(nodePlacesSkin("Autodesk Softimage, Crosswalk", SkinNode::Auto));
    for (const char* tool : {"", "Blender 3.4.1", "OpenCOLLADA for 3ds Max", "FBX COLLADA exporter",
                             "SceneKit Collada Exporter"}) {
        EXPECT_FALSE(nodePlacesSkin(tool, SkinNode::Auto)) << tool;
        EXPECT_TRUE(nodePlacesSkin(tool, SkinNode::Apply)) << tool;
    }
    EXPECT_FALSE(nodePlacesSkin("ColladaMaya", SkinNode::Ignore));
}

}  // namespace
}  // namespace walkcycle
