#include <cstddef>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "animation/SkinPlacement.h"
#include "walkcycle/animation/Skin.h"

namespace walkcycle {
namespace {

template <typename Number>
glm::mat<4, 4, Number> moved(double x) {
    return glm::translate(glm::mat<4, 4, Number>(1), {Number(x), Number(0), Number(0)});
}

Skin skinOf(int placedBy, int placedRelativeTo) {
    Skin skin;
    skin.placedBy = placedBy;
    skin.placedRelativeTo = placedRelativeTo;
    return skin;
}

template <typename Number>
Number shiftOf(const Skin& skin, const std::vector<glm::mat<4, 4, Number>>& modelTransforms) {
    return skinPlacement(skin, [&](int joint) { return modelTransforms[static_cast<std::size_t>(joint)]; })[3]
        .x;
}

TEST(SkinPlacementTest, isTheNodesTransformSinceTheCommonAncestor) {
    const Skin skin = skinOf(1, 0);

    EXPECT_EQ(shiftOf<float>(skin, {moved<float>(2.0), moved<float>(5.0)}), 3.0f);
    EXPECT_EQ(shiftOf<double>(skin, {moved<double>(2.0), moved<double>(5.0)}), 3.0);
}

TEST(SkinPlacementTest, isRelativeToTheRootWithoutACommonAncestor) {
    Skin skin = skinOf(0, kNoParent);
    skin.placedInRoot = moved<float>(0.5);

    EXPECT_EQ(shiftOf<float>(skin, {moved<float>(2.0)}), 1.5f);
    EXPECT_EQ(shiftOf<double>(skin, {moved<double>(2.0)}), 1.5);
}

TEST(SkinPlacementTest, isNothingBelowAnAncestorScaledToNothing) {
    const Skin skin = skinOf(1, 0);

    EXPECT_EQ(shiftOf<float>(skin, {glm::mat4(0.0f), moved<float>(5.0)}), 0.0f);
}

}  // namespace
}  // namespace walkcycle
