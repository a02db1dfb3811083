#include <gtest/gtest.h>

#include "walkcycle/model/Material.h"

namespace walkcycle {
namespace {

Material materialOf(OpaqueMode opaque, float transparency) {
    Material material;
    material.opaque = opaque;
    material.transparency = transparency;
    return material;
}

constexpr glm::vec4 kHalfAlpha{1.0f, 1.0f, 1.0f, 0.5f};
constexpr glm::vec4 kGreen{0.0f, 1.0f, 0.0f, 1.0f};

TEST(MaterialTest, aOneTakesAlphaAsOpacity) {
    EXPECT_FLOAT_EQ(opacity(materialOf(OpaqueMode::AOne, 0.5f), kHalfAlpha), 0.25f);
    EXPECT_FLOAT_EQ(opacity(materialOf(OpaqueMode::AOne, 1.0f), kGreen), 1.0f);
}

TEST(MaterialTest, rgbZeroTakesLuminanceAsWhatShinesThrough) {
    EXPECT_NEAR(opacity(materialOf(OpaqueMode::RgbZero, 1.0f), kGreen), 1.0f - 0.71516f, 1e-6f);
    EXPECT_NEAR(opacity(materialOf(OpaqueMode::RgbZero, 0.5f), glm::vec4(1.0f)), 0.5f, 1e-6f);
    EXPECT_FLOAT_EQ(opacity(materialOf(OpaqueMode::RgbZero, 1.0f), {0.0f, 0.0f, 0.0f, 1.0f}), 1.0f);
}

TEST(MaterialTest, theModesOf15AreTheOthersTurnedRound) {
    EXPECT_FLOAT_EQ(opacity(materialOf(OpaqueMode::AZero, 0.5f), kHalfAlpha), 0.75f);
    EXPECT_NEAR(opacity(materialOf(OpaqueMode::RgbOne, 1.0f), kGreen), 0.71516f, 1e-6f);
}

TEST(MaterialTest, opacityStaysBetweenNothingAndAll) {
    EXPECT_FLOAT_EQ(opacity(materialOf(OpaqueMode::AOne, 100.0f), kGreen), 1.0f);
    EXPECT_FLOAT_EQ(opacity(materialOf(OpaqueMode::RgbZero, 100.0f), kGreen), 0.0f);
}

}  // namespace
}  // namespace walkcycle
