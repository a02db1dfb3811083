#include <cmath>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include "loaders/GeometryFixture.h"
#include "model/SmoothNormals.h"

namespace walkcycle {
namespace {

const std::string kVertex = input("VERTEX", "verts", 0);

void expectNear(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_LT(glm::length(actual - expected), 1e-5f)
        << actual.x << " " << actual.y << " " << actual.z << ", not " << expected.x << " " << expected.y
        << " " << expected.z;
}

// Two squares that share the edge from (0, 0, 0) to (0, 1, 0): one in the plane z = 0, the other bent down by that
// many degrees.
GeometryFixture bent(float degrees) {
    const float angle = glm::radians(degrees);
    const std::string x = std::to_string(std::cos(angle)), z = std::to_string(-std::sin(angle));
    return GeometryFixture(vertices("-1 0 0 0 0 0 0 1 0 -1 1 0 " + x + " 0 " + z + " " + x + " 1 " + z) +
                           "<polylist count=\"2\">" + kVertex +
                           "<vcount>4 4</vcount><p>0 1 2 3 1 4 5 2</p></polylist>");
}

TEST(SmoothNormalsTest, aGentleBendIsSmooth) {
    const GeometryFixture mesh = bent(60.0f);

    EXPECT_EQ(mesh.mesh().vertexCount(), 6u);
    expectNear(mesh.mesh().normals[1], {0.5f, 0.0f, std::sqrt(0.75f)});  // half way: 30 degrees
    expectNear(mesh.mesh().normals[0], {0, 0, 1});
}

TEST(SmoothNormalsTest, aSharpBendKeepsItsEdge) {
    const GeometryFixture mesh = bent(90.0f);

    EXPECT_EQ(mesh.mesh().vertexCount(), 8u);
    for (const glm::vec3& normal : mesh.mesh().normals) EXPECT_TRUE(normal.x > 0.9999f || normal.z > 0.9999f);
}

TEST(SmoothNormalsTest, facesWeighAsMuchAsTheirAngle) {
    // At the origin: a right angle in z = 0, and half of one in x = 0 bent by 45 degrees about the y axis.
    const GeometryFixture mesh(vertices("0 0 0 -1 0 0 0 1 0 1 1 -1 9 0 0") + "<triangles count=\"2\">" +
                               kVertex + "<p>0 2 1 0 3 2</p></triangles>");
    const glm::vec3 flat(0, 0, 1), slope = glm::normalize(glm::vec3(1, 0, 1));
    const float angle = std::acos(1.0f / std::sqrt(3.0f));  // between (1, 1, -1) and (0, 1, 0)

    expectNear(mesh.mesh().normals[0], glm::normalize(glm::radians(90.0f) * flat + angle * slope));
}

TEST(SmoothNormalsTest, howAPolygonIsCutLeavesNoTrace) {
    // A pyramid with a square base: as quads and triangles it is symmetric, so its tip's normal points straight up.
    const GeometryFixture roof(vertices("0 0 1 2 0 0 2 2 0 0 2 0 -2 2 0 -2 0 0 -2 -2 0 0 -2 0 2 -2 0") +
                               "<polylist count=\"4\">" + kVertex +
                               "<vcount>4 4 4 4</vcount><p>0 1 2 3 0 3 4 5 0 5 6 7 0 7 8 1</p></polylist>");

    expectNear(roof.mesh().normals[0], {0, 0, 1});
}

TEST(SmoothNormalsTest, repeatedPositionsMakeNoSeam) {
    const GeometryFixture mesh(vertices("-1 0 0 0 0 0 0 1 0 -1 1 0 0 0 0 0.8 0 -0.6 0.8 1 -0.6 0 1 0") +
                               "<polylist count=\"2\">" + kVertex +
                               "<vcount>4 4</vcount><p>0 1 2 3 4 5 6 7</p></polylist>");

    expectNear(mesh.mesh().normals[1], mesh.mesh().normals[4]);
    EXPECT_GT(mesh.mesh().normals[1].x, 0.1f);
}

TEST(SmoothNormalsTest, materialsMakeNoSeam) {
    const GeometryFixture mesh(
        vertices("-1 0 0 0 0 0 0 1 0 -1 1 0 0.8 0 -0.6 0.8 1 -0.6") +
        "<polylist count=\"1\" material=\"a\">" + kVertex +
        "<vcount>4</vcount><p>0 1 2 3</p></polylist><polylist count=\"1\" material=\"b\">" + kVertex +
        "<vcount>4</vcount><p>1 4 5 2</p></polylist>");

    EXPECT_EQ(mesh.mesh().parts.size(), 2u);
    EXPECT_EQ(mesh.mesh().vertexCount(), 6u);
}

TEST(SmoothNormalsTest, twoSidesOfASheetDoNotCancel) {
    const GeometryFixture sheet(vertices(kSquare) + "<polylist count=\"2\">" + kVertex +
                                "<vcount>4 4</vcount><p>0 1 2 3 3 2 1 0</p></polylist>");

    EXPECT_EQ(sheet.mesh().vertexCount(), 8u);
    for (const glm::vec3& normal : sheet.mesh().normals) EXPECT_FLOAT_EQ(std::abs(normal.z), 1.0f);
}

TEST(SmoothNormalsTest, aReflexCornerIsWeighedByItsWholeAngle) {
    // An L in z = 0 whose inner corner (270 degrees) meets a triangle of 90 degrees in the plane x + z = 1.
    const MeshFaces faces{{{0, 6, false}, {6, 3, false}}, {0, 1, 2, 3, 4, 5, 3, 6, 7}};
    const std::vector<glm::vec3> positions{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0},
                                           {1, 2, 0}, {0, 2, 0}, {1, 3, 0}, {0, 1, 1}};
    const std::vector<glm::vec3> normals = smoothNormals(faces, positions, positions);
    const glm::vec3 slope =
        glm::normalize(glm::cross(positions[6] - positions[3], positions[7] - positions[3]));

    expectNear(normals[3],
               slope.z > 0 ? glm::normalize(3.0f * glm::vec3(0, 0, 1) + slope) : glm::vec3(0, 0, 1));
}

TEST(SmoothNormalsTest, aFaceWithoutAreaTakesItsNeighboursNormal) {
    const GeometryFixture mesh(vertices("0 0 0 1 0 0 1 1 0 2 0 0") + "<triangles count=\"2\">" + kVertex +
                               "<p>0 1 2 0 1 3</p></triangles>");

    for (std::size_t v = 0; v < 3; ++v) expectNear(mesh.mesh().normals[v], {0, 0, 1});
    for (const glm::vec3& normal : mesh.mesh().normals) EXPECT_FLOAT_EQ(glm::length(normal), 1.0f);
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
    const std::vector<glm::vec3> normals = smoothNormals(faces, positions, positions);

    expectNear(normals[0], {0, 0, 1});
}

TEST(SmoothNormalsTest, hugeAndTinyPositionsHaveNormals) {
    for (const char* scale : {"1e38", "1e-30"}) {
        const std::string s = scale;
        const GeometryFixture mesh(vertices("0 0 0 " + s + " 0 0 0 " + s + " 0") + "<triangles count=\"1\">" +
                                   kVertex + "<p>0 1 2</p></triangles>");
        expectNear(mesh.mesh().normals.at(0), {0, 0, 1});
    }
}

}  // namespace
}  // namespace walkcycle
