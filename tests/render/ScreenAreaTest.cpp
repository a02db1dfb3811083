#include <climits>
#include <vector>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "render/ScreenArea.h"
#include "render/TestModels.h"

namespace walkcycle {
namespace {

const glm::ivec4 kWhole{0, 0, INT_MAX, INT_MAX};

Bounds cube(float half) {
    return {.min = glm::vec3(-half), .max = glm::vec3(half)};
}

TEST(ScreenAreaTest, holdsABoxAndALittleMore) {
    ScreenArea area = ScreenArea::none(100, 200);
    area.add(cube(0.5f), glm::mat4(1.0f));
    EXPECT_EQ(area.pixels(), glm::ivec4(22, 47, 78, 153));
}

TEST(ScreenAreaTest, endsWithThePicture) {
    ScreenArea area = ScreenArea::none(100, 200);
    area.add(cube(0.5f), glm::translate(glm::mat4(1.0f), {-1.0f, 1e9f, 0.0f}));
    EXPECT_EQ(area.pixels(), glm::ivec4(0, 199, 28, 199));
}

TEST(ScreenAreaTest, isTheWholePictureWhereABoxReachesBehindTheCamera) {
    ScreenArea area = ScreenArea::none(100, 200);
    area.add(cube(1.0f), glm::perspective(1.0f, 1.0f, 0.1f, 10.0f));
    EXPECT_EQ(area.pixels(), kWhole);
    area.add(cube(0.5f), glm::mat4(1.0f));
    EXPECT_EQ(area.pixels(), kWhole);
}

TEST(ScreenAreaTest, eachMatrixHasABoxAroundThePositionsThatItPulls) {
    const MeshData mesh = testing_models::square();
    const Influences influences{.first = {0, 1, 2, 4, 5},
                                .influences = {{0, 1.0f}, {0, 1.0f}, {0, 0.5f}, {1, 0.5f}, {1, 1.0f}}};
    const std::vector<Bounds> boxes = boxesOfMatrices(mesh, &influences, 3);
    ASSERT_EQ(boxes.size(), 3u);
    EXPECT_EQ(boxes[0].min, glm::vec3(-1, -1, 0));
    EXPECT_EQ(boxes[0].max, glm::vec3(1, 1, 0));
    EXPECT_EQ(boxes[1].min, glm::vec3(-1, 1, 0));
    EXPECT_EQ(boxes[1].max, glm::vec3(1, 1, 0));
    EXPECT_TRUE(boxes[2].empty());
}

TEST(ScreenAreaTest, noBoxHoldsWhatAWeightBelowZeroMoves) {
    const MeshData mesh = testing_models::square();
    const Influences influences{.first = {0, 2, 2, 2, 2}, .influences = {{0, 1.5f}, {1, -0.5f}}};
    EXPECT_TRUE(boxesOfMatrices(mesh, &influences, 2).empty());
}

}  // namespace
}  // namespace walkcycle
