#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include <gtest/gtest.h>

#include "loaders/materials/BumpMap.h"

namespace walkcycle {
namespace {

// Greys that rise from left to right, four by four.
Image slope() {
    Image image{.width = 4, .height = 4, .hasAlpha = false, .rgba = {}};
    for (int row = 0; row < 4; ++row)
        for (const auto grey : std::initializer_list<std::uint8_t>{0, 50, 100, 150})
            for (const std::uint8_t byte : {grey, grey, grey, std::uint8_t{255}}) image.rgba.push_back(byte);
    return image;
}

TEST(BumpMapTest, greysAreHeights) {
    Image image = slope();
    EXPECT_TRUE(holdsHeights(image));
    image.rgba[2] = 255;
    EXPECT_FALSE(holdsHeights(image));
}

TEST(BumpMapTest, aSurfaceThatRisesToTheRightLeansToTheLeft) {
    const Image normals = normalsOfHeights(slope());
    const std::size_t inside = (4 + 1) * 4;

    EXPECT_LT(normals.rgba[inside], 100);
    EXPECT_EQ(normals.rgba[inside + 1], 128);
    EXPECT_GT(normals.rgba[inside + 2], 200);
    EXPECT_EQ(normals.rgba[inside + 3], 255);
}

TEST(BumpMapTest, aFlatSurfaceFacesUs) {
    const Image flat{.width = 1, .height = 1, .hasAlpha = false, .rgba = {77, 77, 77, 255}};

    EXPECT_EQ(normalsOfHeights(flat).rgba, (Bytes{128, 128, 255, 255}));
}

}  // namespace
}  // namespace walkcycle
