#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

void expectNear(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_LT(glm::length(actual - expected), 1e-5f)
        << actual.x << " " << actual.y << " " << actual.z << ", not " << expected.x << " " << expected.y
        << " " << expected.z;
}

// Polygons by the positions of their corners.
MeshFaces facesOf(std::initializer_list<std::vector<std::uint32_t>> polygons) {
    MeshFaces faces;
    for (const std::vector<std::uint32_t>& polygon : polygons) {
        faces.rings.push_back({static_cast<std::uint32_t>(faces.cornerPositions.size()),
                               static_cast<std::uint32_t>(polygon.size()), false});
        faces.cornerPositions.insert(faces.cornerPositions.end(), polygon.begin(), polygon.end());
    }
    return faces;
}

std::vector<glm::vec3> normalsOf(const MeshFaces& faces, const std::vector<glm::vec3>& positions) {
    return smoothNormals(faces, positions, positions);
}

// Two squares that share the edge from (0, 0, 0) to (0, 1, 0): one in the plane z = 0, the other bent down by that
// many degrees. Corners 1 and 4 stand at (0, 0, 0).
std::vector<glm::vec3> bent(float degrees) {
    const float x = std::cos(glm::radians(degrees)), z = -std::sin(glm::radians(degrees));
    return normalsOf(facesOf({{0, 1, 2, 3}, {1, 4, 5, 2}}),
                     {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {x, 0, z}, {x, 1, z}});
}

TEST(SmoothNormalsTest, aGentleBendIsSmooth) {
    const std::vector<glm::vec3> normals = bent(60.0f);

    expectNear(normals[1], {0.5f, 0.0f, std::sqrt(0.75f)});  // half way: 30 degrees
    expectNear(normals[4], normals[1]);
    expectNear(normals[0], {0, 0, 1});
}

TEST(SmoothNormalsTest, aSharpBendKeepsItsEdge) {
    const std::vector<glm::vec3> normals = bent(90.0f);

    for (std::size_t corner = 0; corner < 4; ++corner) expectNear(normals[corner], {0, 0, 1});
    for (std::size_t corner = 4; corner < 8; ++corner) expectNear(normals[corner], {1, 0, 0});
}

TEST(SmoothNormalsTest, facesWeighAsMuchAsTheirAngle) {
    // At the origin: a right angle in z = 0, and half of one in x = 0 bent by 45 degrees about the y axis.
    const std::vector<glm::vec3> normals =
        normalsOf(facesOf({{0, 2, 1}, {0, 3, 2}}), {{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {1, 1, -1}});
    const glm::vec3 flat(0, 0, 1), slope = glm::normalize(glm::vec3(1, 0, 1));
    const float angle = std::acos(1.0f / std::sqrt(3.0f));  // between (1, 1, -1) and (0, 1, 0)

    expectNear(normals[0], glm::normalize(glm::radians(90.0f) * flat + angle * slope));
}

TEST(SmoothNormalsTest, howAPolygonIsCutLeavesNoTrace) {
    // A roof of four quads about its tip is symmetric, so the tip's normal points straight up.
    const std::vector<glm::vec3> normals =
        normalsOf(facesOf({{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 7}, {0, 7, 8, 1}}), {{0, 0, 1},
                                                                                      {2, 0, 0},
                                                                                      {2, 2, 0},
                                                                                      {0, 2, 0},
                                                                                      {-2, 2, 0},
                                                                                      {-2, 0, 0},
                                                                                      {-2, -2, 0},
                                                                                      {0, -2, 0},
                                                                                      {2, -2, 0}});

    expectNear(normals[0], {0, 0, 1});
}

TEST(SmoothNormalsTest, repeatedPositionsMakeNoSeam) {
    const std::vector<glm::vec3> normals = normalsOf(facesOf({{0, 1, 2, 3}, {4, 5, 6, 7}}), {{-1, 0, 0},
                                                                                             {0, 0, 0},
                                                                                             {0, 1, 0},
                                                                                             {-1, 1, 0},
                                                                                             {0, 0, 0},
                                                                                             {0.8f, 0, -0.6f},
                                                                                             {0.8f, 1, -0.6f},
                                                                                             {0, 1, 0}});

    expectNear(normals[1], normals[4]);
    EXPECT_GT(normals[1].x, 0.1f);
}

TEST(SmoothNormalsTest, twoSidesOfASheetDoNotCancel) {
    const std::vector<glm::vec3> normals =
        normalsOf(facesOf({{0, 1, 2, 3}, {3, 2, 1, 0}}), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});

    for (std::size_t corner = 0; corner < 8; ++corner)
        expectNear(normals[corner], {0, 0, corner < 4 ? 1 : -1});
}

TEST(SmoothNormalsTest, aReflexCornerIsWeighedByItsWholeAngle) {
    // An L in z = 0 whose inner corner (270 degrees) meets a triangle of 90 degrees in the plane x + z = 1.
    const std::vector<glm::vec3> positions{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0},
                                           {1, 2, 0}, {0, 2, 0}, {1, 3, 0}, {0, 1, 1}};
    const std::vector<glm::vec3> normals = normalsOf(facesOf({{0, 1, 2, 3, 4, 5}, {3, 6, 7}}), positions);
    const glm::vec3 slope =
        glm::normalize(glm::cross(positions[6] - positions[3], positions[7] - positions[3]));

    expectNear(normals[3],
               slope.z > 0 ? glm::normalize(3.0f * glm::vec3(0, 0, 1) + slope) : glm::vec3(0, 0, 1));
}

TEST(SmoothNormalsTest, aFaceWithoutAreaTakesItsNeighboursNormal) {
    const std::vector<glm::vec3> normals =
        normalsOf(facesOf({{0, 1, 2}, {0, 1, 3}}), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}});

    for (std::size_t corner = 0; corner < 5; ++corner) expectNear(normals[corner], {0, 0, 1});
    EXPECT_FLOAT_EQ(glm::length(normals[5]), 1.0f);
}

TEST(SmoothNormalsTest, aHundredThousandFacesAtOnePointDoNotHang) {
    MeshFaces faces;
    std::vector<glm::vec3> positions{{0, 0, 0}};
    for (std::uint32_t i = 0; i < 100'000; ++i) {
        const float angle = static_cast<float>(i) * 6.2831853e-5f;
        positions.push_back({std::cos(angle), std::sin(angle), 0.0f});
        faces.rings.push_back({3 * i, 3, false});
        faces.cornerPositions.insert(faces.cornerPositions.end(), {0, i + 1, i == 99'999 ? 1 : i + 2});
    }

    expectNear(normalsOf(faces, positions)[0], {0, 0, 1});
}

TEST(SmoothNormalsTest, hugeAndTinyPositionsHaveNormals) {
    for (const float scale : {1e38f, 1e-30f})
        expectNear(normalsOf(facesOf({{0, 1, 2}}), {{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}})[0], {0, 0, 1});
}

}  // namespace
}  // namespace walkcycle
