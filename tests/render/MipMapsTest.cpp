#include <cstdint>
#include <utility>

#include <gtest/gtest.h>

#include "render/MipMaps.h"
#include "render/Srgb.h"

namespace walkcycle {
namespace {

Image image(int width, int height, bool hasAlpha, Bytes rgba) {
    return {.width = width, .height = height, .hasAlpha = hasAlpha, .rgba = std::move(rgba)};
}

TEST(MipMapsTest, blackAndWhiteAverageToHalfTheLight) {
    const Image checks =
        image(2, 2, false, {0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 255});
    EXPECT_EQ(halved(checks, TexelKind::Color).rgba, (Bytes{188, 188, 188, 255}));
    EXPECT_NEAR(halved(checks, TexelKind::Data).rgba[0], 128, 1);
}

TEST(MipMapsTest, everyGreyKeepsItsValue) {
    for (int grey = 0; grey < 256; ++grey) {
        const auto g = static_cast<std::uint8_t>(grey);
        Bytes rgba;
        for (int i = 0; i < 4; ++i) rgba.insert(rgba.end(), {g, g, g, 255});
        EXPECT_EQ(halved(image(2, 2, false, rgba), TexelKind::Color).rgba[0], g);
        EXPECT_EQ(halved(image(4, 1, true, rgba), TexelKind::Color).rgba[0], g);
    }
}

TEST(MipMapsTest, clearTexelsDoNotBleedTheirColour) {
    const Image edge = image(2, 1, true, {200, 100, 50, 255, 0, 255, 0, 0});
    EXPECT_EQ(halved(edge, TexelKind::Color).rgba, (Bytes{200, 100, 50, 128}));
}

TEST(MipMapsTest, levelsGoDownToOneTexelAlsoAtOddSizes) {
    const Image odd = image(13, 5, false, Bytes(13 * 5 * 4, 255));
    const auto levels = mipMaps(odd, TexelKind::Color);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_EQ(levels[0].width, 6);
    EXPECT_EQ(levels[0].height, 2);
    EXPECT_EQ(levels.back().width, 1);
    EXPECT_EQ(levels.back().height, 1);
}

TEST(SrgbTest, everyByteSurvivesBecomingLightAndBack) {
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(srgbOfLinear(linearOfSrgb(static_cast<std::uint8_t>(i))), i);
    }
}

}  // namespace
}  // namespace walkcycle
