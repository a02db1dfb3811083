#include <stdexcept>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include "walkcycle/model/Influences.h"
#include "walkcycle/model/MeshData.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatEq;

// Two positions, of which the second is drawn as two vertices. The first has three influences, the second one.
MeshData mesh() {
    MeshData mesh;
    mesh.positions = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    mesh.vertexPositions = {1, 0, 1};
    return mesh;
}

Influences influences() {
    return {.first = {0, 3, 4}, .influences = {{5, 0.2f}, {6, 0.5f}, {7, 0.3f}, {4, 1.0f}}};
}

TEST(LimitedInfluencesTest, theLargestAreKeptAndSumToOneAgain) {
    const LimitedInfluences limited = limitInfluences(influences(), mesh(), 2);

    EXPECT_EQ(limited.perVertex, 2u);
    EXPECT_THAT(limited.joints, ElementsAre(4, 0, 6, 7, 4, 0));
    EXPECT_THAT(limited.weights, ElementsAre(1.0f, 0.0f, FloatEq(0.625f), FloatEq(0.375f), 1.0f, 0.0f));
}

TEST(LimitedInfluencesTest, whatWasLeftOutIsCountedAndWeighed) {
    const LimitedInfluences limited = limitInfluences(influences(), mesh(), 1);
    EXPECT_EQ(limited.cutVertices, 1u);
    EXPECT_FLOAT_EQ(limited.largestDropped, 0.3f);

    const LimitedInfluences whole = limitInfluences(influences(), mesh(), 3);
    EXPECT_EQ(whole.cutVertices, 0u);
    EXPECT_EQ(whole.largestDropped, 0.0f);
}

TEST(LimitedInfluencesTest, equalWeightsAreKeptInTheFilesOrder) {
    MeshData point = mesh();
    point.vertexPositions = {0};
    const Influences equal{.first = {0, 3, 3}, .influences = {{9, 0.25f}, {3, 0.5f}, {8, 0.25f}}};
    EXPECT_THAT(limitInfluences(equal, point, 2).joints, ElementsAre(3, 9));
}

TEST(LimitedInfluencesTest, aVertexThatFollowsNothingStaysAsItIs) {
    MeshData point = mesh();
    point.vertexPositions = {0};
    const LimitedInfluences limited = limitInfluences({.first = {0, 0, 0}, .influences = {}}, point, 2);
    EXPECT_THAT(limited.weights, ElementsAre(0.0f, 0.0f));
}

TEST(LimitedInfluencesTest, theErrorIsHowFarAVertexStandsFromWhereAllInfluencesPutIt) {
    std::vector<glm::mat4> palette(8, glm::mat4(1.0f));
    palette[5] = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 10.0f, 0.0f));
    // All: 0.2 * 10 up; the two that are kept do not move it.
    EXPECT_FLOAT_EQ(limitingError(limitInfluences(influences(), mesh(), 2), influences(), mesh(), palette),
                    2.0f);
    EXPECT_FLOAT_EQ(limitingError(limitInfluences(influences(), mesh(), 3), influences(), mesh(), palette),
                    0.0f);
}

TEST(LimitedInfluencesTest, noInfluenceAtAllAndAnotherMeshAreRefused) {
    EXPECT_THROW(limitInfluences(influences(), mesh(), 0), std::invalid_argument);
    EXPECT_THROW(limitInfluences({.first = {0, 0}, .influences = {}}, mesh(), 4), std::invalid_argument);
}

}  // namespace
}  // namespace walkcycle
