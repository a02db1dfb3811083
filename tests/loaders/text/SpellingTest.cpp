#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "loaders/text/Spelling.h"

namespace walkcycle {
namespace {

TEST(SpellingTest, findsTheWordThatWasMeant) {
    constexpr std::string_view kKnown = "triangles polylist vcount vertex_weights p";
    EXPECT_EQ(nearest("trinagles", kKnown), "triangles");
    EXPECT_EQ(nearest("vertex_weight", kKnown), "vertex_weights");
    EXPECT_EQ(nearest("PolyList", kKnown), "polylist");
    EXPECT_EQ(nearest("v_count", kKnown), "vcount");
}

TEST(SpellingTest, doesNotGuessWildly) {
    constexpr std::string_view kKnown = "triangles polylist vcount p h";
    EXPECT_EQ(nearest("subdivision", kKnown), "");
    EXPECT_EQ(nearest("q", kKnown), "");
    EXPECT_EQ(nearest("", kKnown), "");
    EXPECT_EQ(nearest(std::string(100000, 'v'), kKnown), "");
}

TEST(SpellingTest, asksOnlyWhereThereIsSomethingToAsk) {
    EXPECT_EQ(didYouMean("NORML", "NORMAL TEXCOORD"), "; perhaps 'NORMAL' is meant");
    EXPECT_EQ(didYouMean("SHININESS", "NORMAL TEXCOORD"), "");
}

TEST(SpellingTest, aNameMayDifferInCaseAlone) {
    EXPECT_EQ(inAnotherCase({"a.png", "Skin.PNG"}, "skin.png"), "Skin.PNG");
    EXPECT_EQ(inAnotherCase({"skin2.png"}, "skin.png"), "");
    EXPECT_EQ(inAnotherCase({}, "skin.png"), "");
}

}  // namespace
}  // namespace walkcycle
