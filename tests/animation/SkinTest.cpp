#include <cstddef>
#include <span>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "walkcycle/animation/Skin.h"

namespace walkcycle {
namespace {

glm::mat4 moved(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

glm::vec3 origin(const glm::mat4& matrix) {
    return glm::vec3(matrix[3]);
}

// One joint, bound two up; then the skin's own node, as every skin has it last. The mesh is bound at `bindShape`.
Skin oneJointSkin(const glm::mat4& bindShape = glm::mat4(1.0f)) {
    Skin skin;
    skin.joints = {0, 1};
    skin.bindMatrices = {moved(0.0f, -2.0f, 0.0f) * bindShape, bindShape};
    return skin;
}

TEST(SkinTest, inTheBindPoseTheMeshStaysWhereItsBindShapeIs) {
    const Skin skin = oneJointSkin(moved(5.0f, 0.0f, 0.0f));
    std::vector<glm::mat4> palette;
    computePalette(skin, {moved(0.0f, 2.0f, 0.0f), glm::mat4(1.0f)}, palette);

    ASSERT_EQ(palette.size(), 2u);
    EXPECT_EQ(origin(palette[0]), glm::vec3(5.0f, 0.0f, 0.0f));
}

TEST(SkinTest, aRotatedJointRotatesTheBindShapeAboutItself) {
    const Skin skin = oneJointSkin(moved(1.0f, 2.0f, 0.0f));
    const glm::mat4 rotated =
        glm::rotate(moved(0.0f, 2.0f, 0.0f), glm::radians(90.0f), glm::vec3(0.0f, 0.0f, 1.0f));
    std::vector<glm::mat4> palette;
    computePalette(skin, {rotated, glm::mat4(1.0f)}, palette);

    EXPECT_NEAR(origin(palette[0]).x, 0.0f, 1e-6f);
    EXPECT_NEAR(origin(palette[0]).y, 3.0f, 1e-6f);
}

TEST(SkinTest, verticesWithoutInfluenceFollowTheNode) {
    std::vector<glm::mat4> palette;
    computePalette(oneJointSkin(), {glm::mat4(1.0f), moved(0.0f, 0.0f, 9.0f)}, palette);

    EXPECT_EQ(origin(palette[1]), glm::vec3(0.0f, 0.0f, 9.0f));
}

TEST(SkinTest, theNodeMovesNothingElseUnlessItPlacesTheSkin) {
    std::vector<glm::mat4> palette;
    computePalette(oneJointSkin(), {moved(0.0f, 2.0f, 0.0f), moved(0.0f, 0.0f, 9.0f)}, palette);

    EXPECT_EQ(origin(palette[0]), glm::vec3(0.0f));
}

TEST(SkinTest, aPlacingNodeAddsItsTransformSinceTheCommonAncestor) {
    Skin skin = oneJointSkin();
    skin.joints = {1, 2};
    skin.placedBy = 2;
    skin.placedRelativeTo = 0;
    const glm::mat4 ancestor = moved(100.0f, 0.0f, 0.0f);
    std::vector<glm::mat4> palette;
    computePalette(skin, {ancestor, ancestor * moved(0.0f, 2.0f, 0.0f), ancestor * moved(0.0f, 0.0f, 9.0f)},
                   palette);

    EXPECT_EQ(origin(palette[0]), glm::vec3(100.0f, 0.0f, 9.0f));
    EXPECT_EQ(origin(palette[1]), glm::vec3(100.0f, 0.0f, 9.0f));  // not placed twice
}

TEST(SkinTest, withoutACommonAncestorThePlacementIsRelativeToTheRoot) {
    Skin skin = oneJointSkin();
    const glm::mat4 root = glm::scale(glm::mat4(1.0f), glm::vec3(0.5f));
    skin.placedBy = 1;
    skin.placedInRoot = root;
    std::vector<glm::mat4> palette;
    computePalette(skin, {root * moved(0.0f, 2.0f, 0.0f), root * moved(0.0f, 0.0f, 8.0f)}, palette);

    EXPECT_EQ(origin(palette[0]), glm::vec3(0.0f, 0.0f, 4.0f));
    EXPECT_FLOAT_EQ(palette[0][0].x, 0.5f);  // the unit is converted once
}

TEST(SkinTest, anAncestorScaledToNothingGivesNoInfinities) {
    Skin skin = oneJointSkin();
    skin.placedBy = 1;
    skin.placedRelativeTo = 0;
    std::vector<glm::mat4> palette;
    computePalette(skin, {glm::mat4(0.0f), glm::mat4(0.0f)}, palette);

    for (int column = 0; column < 4; ++column) EXPECT_EQ(palette[0][column], glm::vec4(0.0f));
}

TEST(SkinTest, thePaletteOfRowsIsTheSame) {
    Skin skin = oneJointSkin(moved(1.0f, 2.0f, 3.0f));
    skin.placedBy = 1;
    const std::vector<glm::mat4> transforms{glm::rotate(moved(0.0f, 2.0f, 0.0f), 0.7f, glm::vec3(1.0f)),
                                            moved(4.0f, 5.0f, 6.0f)};
    std::vector<glm::mat4> palette;
    std::vector<JointRows> rows(2);
    computePalette(skin, transforms, palette);
    computePalette(skin, transforms, std::span(rows));

    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(rows[i].toMatrix(), palette[i]);
}

}  // namespace
}  // namespace walkcycle
