#include <string>

#include <gmock/gmock.h>

#include "loaders/GeometryFixture.h"
#include "loaders/geometry/GeometryLoader.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kVertex = input("VERTEX", "verts", 0);

TEST(GeometryLoaderTest, trianglesAreReadCornerByCorner) {
    const GeometryFixture square(vertices(kSquare) + "<triangles count=\"2\" material=\"skin\">" + kVertex +
                                 "<p>0 1 2 0 2 3</p></triangles>");

    EXPECT_THAT(square.drawnPositions(), ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_EQ(square.mesh().vertexCount(), 4u);
    ASSERT_EQ(square.mesh().parts.size(), 1u);
    EXPECT_EQ(square.mesh().parts[0].materialSymbol, "skin");
    EXPECT_EQ(square.mesh().parts[0].indexCount, 6u);
    EXPECT_THAT(square.said(), IsEmpty());
}

TEST(GeometryLoaderTest, polylistsOfAnySizesAreCut) {
    const GeometryFixture mixed(vertices(kSquare + " 2 0 0") + "<polylist count=\"2\">" + kVertex +
                                "<vcount>4 3</vcount><p>0 1 2 3 1 4 2</p></polylist>");

    EXPECT_THAT(mixed.drawnPositions(), ElementsAre(0, 1, 2, 0, 2, 3, 1, 4, 2));
    EXPECT_THAT(mixed.said(), IsEmpty());
}

TEST(GeometryLoaderTest, eachPOfPolygonsIsOne) {
    const GeometryFixture two(vertices(kSquare + " 2 0 0") + "<polygons count=\"2\">" + kVertex +
                              "<p>0 1 2 3</p><p>1 4 2</p></polygons>");

    EXPECT_THAT(two.drawnPositions(), ElementsAre(0, 1, 2, 0, 2, 3, 1, 4, 2));
    EXPECT_THAT(two.said(), IsEmpty());
}

TEST(GeometryLoaderTest, polygonsMayHaveHoles) {
    const GeometryFixture frame(vertices("0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 3 1 0 3 3 0 1 3 0") +
                                "<polygons count=\"1\">" + kVertex +
                                "<ph><p>0 1 2 3</p><h>4 5 6 7</h></ph></polygons>");

    EXPECT_FLOAT_EQ(frame.areaTowardsZ(), 12.0f);  // 4 x 4 without 2 x 2
    EXPECT_EQ(frame.mesh().indices.size(), 8u * 3);
    EXPECT_THAT(frame.mesh().positionUsed, ::testing::Each(true));
    EXPECT_THAT(frame.said(), IsEmpty());
}

TEST(GeometryLoaderTest, fansTurnAboutTheirFirstCorner) {
    const GeometryFixture fan(vertices(kSquare) + "<trifans count=\"1\">" + kVertex +
                              "<p>0 1 2 3</p></trifans>");

    EXPECT_THAT(fan.drawnPositions(), ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(fan.said(), IsEmpty());
}

TEST(GeometryLoaderTest, everySecondTriangleOfAStripIsTurnedRound) {
    const GeometryFixture strip(vertices("0 0 0 0 1 0 1 0 0 1 1 0") + "<tristrips count=\"1\">" + kVertex +
                                "<p>0 2 1 3</p></tristrips>");

    EXPECT_THAT(strip.drawnPositions(), ElementsAre(0, 2, 1, 1, 2, 3));
    EXPECT_FLOAT_EQ(strip.areaTowardsZ(), 1.0f);
    EXPECT_THAT(strip.said(), IsEmpty());
}

TEST(GeometryLoaderTest, linesAndLineStripsAreDrawnButAreNoSurface) {
    const GeometryFixture lines(vertices(kSquare) + "<lines count=\"2\">" + kVertex +
                                "<p>0 1 2 3</p></lines>" + "<linestrips count=\"1\">" + kVertex +
                                "<p>0 1 2</p></linestrips>");

    EXPECT_THAT(lines.drawnPositions(), ElementsAre(0, 1, 2, 3, 0, 1, 1, 2));
    ASSERT_EQ(lines.mesh().parts.size(), 2u);
    EXPECT_EQ(lines.mesh().parts[0].primitive, Primitive::Lines);
    EXPECT_THAT(lines.mesh().positionUsed, ::testing::Each(false));
    EXPECT_THAT(lines.mesh().normals, ::testing::Each(glm::vec3(0.0f)));
    EXPECT_THAT(lines.said(), IsEmpty());
}

TEST(GeometryLoaderTest, offsetsMayBeSharedAndSkipped) {
    const GeometryFixture mesh(vertices(kSquare) + source("uv", 2, "0 0 1 0 1 1 0 1") +
                               source("up", 3, "0 0 1") + "<triangles count=\"1\">" +
                               input("NORMAL", "up", 3) + input("VERTEX", "verts", 1) +
                               input("TEXCOORD", "uv", 1) + "<p>9 1 9 0  9 2 9 0  9 3 9 0</p></triangles>");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(1, 2, 3));
    ASSERT_EQ(mesh.mesh().texCoordSets.size(), 1u);
    EXPECT_EQ(mesh.mesh().texCoordSets[0].coords[1], glm::vec2(1, 1));
    EXPECT_EQ(mesh.mesh().normals[0], glm::vec3(0, 0, 1));
    EXPECT_TRUE(mesh.loaded.hasNormals);
    EXPECT_THAT(mesh.said(), IsEmpty());
}

TEST(GeometryLoaderTest, textureCoordinateSetsKeepTheirNumbers) {
    const GeometryFixture mesh(
        vertices(kSquare) + source("uv", 2, "0 0 1 0 1 1") + source("uv2", 3, "5 6 7 8 9 10") +
        "<triangles count=\"1\">" + kVertex + input("TEXCOORD", "uv", 1, "set=\"2\"") +
        input("TEXCOORD", "uv2", 2, "set=\"0\"") + "<p>0 0 1 1 1 0 2 2 1</p></triangles>");

    ASSERT_EQ(mesh.mesh().texCoordSets.size(), 2u);
    EXPECT_EQ(mesh.mesh().texCoordSets[0].set, 2);
    EXPECT_EQ(mesh.mesh().texCoordSets[0].coords[2], glm::vec2(1, 1));
    EXPECT_EQ(mesh.mesh().texCoordSets[1].set, 0);
    EXPECT_EQ(mesh.mesh().texCoordSets[1].coords[0], glm::vec2(8, 9));  // the third number is left out
}

TEST(GeometryLoaderTest, verticesMayHoldNormalsCoordinatesAndColours) {
    const GeometryFixture mesh(
        source("up", 3, "0 0 2 0 0 2 0 0 2 0 0 2") + source("uv", 2, "0 0 1 0 1 1 0 1") +
        source("rgb", 3, "1 0 0 0 1 0 0 0 1 1 1 1") +
        vertices(kSquare,
                 "<input semantic=\"NORMAL\" source=\"#up\"/>"
                 "<input semantic=\"TEXCOORD\" source=\"#uv\"/>"
                 "<input semantic=\"COLOR\" source=\"#rgb\"/>") +
        "<polylist count=\"1\">" + kVertex + "<vcount>4</vcount><p>0 1 2 3</p></polylist>");

    EXPECT_EQ(mesh.mesh().normals[2], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.mesh().texCoordSets.at(0).coords[3], glm::vec2(0, 1));
    EXPECT_EQ(mesh.mesh().colors.at(1), glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(mesh.loaded.positionNormals.size(), 4u);
    EXPECT_THAT(mesh.said(), IsEmpty());
}

TEST(GeometryLoaderTest, positionsOfTwoNumbersLieInThePlane) {
    const GeometryFixture flat(vertices("0 0 1 0 1 1", "", 2) + "<triangles count=\"1\">" + kVertex +
                               "<p>0 1 2</p></triangles>");

    EXPECT_EQ(flat.mesh().positions.at(2), glm::vec3(1, 1, 0));
    EXPECT_THAT(flat.said(), IsEmpty());
}

TEST(GeometryLoaderTest, cornersJoinByValueNotByIndex) {
    const GeometryFixture mesh(vertices(kSquare) + source("uv", 2, "0 0 1 0 1 1 0 0 1 1 0 1") +
                               "<triangles count=\"2\">" + kVertex + input("TEXCOORD", "uv", 1) +
                               "<p>0 0 1 1 2 2  0 3 2 4 3 5</p></triangles>");

    EXPECT_EQ(mesh.mesh().vertexCount(), 4u);
}

TEST(GeometryLoaderTest, cornersOfOnePositionThatDifferAreTwoVertices) {
    const GeometryFixture mesh(vertices(kSquare) + source("uv", 2, "0 0 1 0 1 1 5 5") +
                               "<triangles count=\"2\">" + kVertex + input("TEXCOORD", "uv", 1) +
                               "<p>0 0 1 1 2 2  0 3 2 2 3 1</p></triangles>");

    EXPECT_EQ(mesh.mesh().vertexCount(), 5u);
    EXPECT_THAT(mesh.loaded.cornerVertices, ElementsAre(0, 1, 2, 3, 2, 4));
}

TEST(GeometryLoaderTest, aMeshWithoutPrimitivesHasItsPositions) {
    const GeometryFixture target(vertices(kSquare));

    EXPECT_EQ(target.mesh().positions.size(), 4u);
    EXPECT_THAT(target.mesh().parts, IsEmpty());
    EXPECT_THAT(target.said(), IsEmpty());
}

TEST(GeometryLoaderTest, theHintForTwoSidesIsRead) {
    const GeometryFixture mesh(
        vertices(kSquare) +
        "<extra><technique profile=\"MAYA\"><double_sided>1</double_sided></technique></extra>");

    EXPECT_TRUE(mesh.mesh().doubleSided);
}

TEST(GeometryLoaderTest, aConvexMeshOfItsOwnIsAMesh) {
    const auto convex =
        GeometryFixture::ofGeometry("<convex_mesh>" + vertices(kSquare) + "<triangles count=\"1\">" +
                                    kVertex + "<p>0 1 2</p></triangles></convex_mesh>");

    EXPECT_THAT(convex.drawnPositions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(convex.said(), IsEmpty());
}

TEST(GeometryLoaderTest, theHullOfAGeometryIsShownAsThatGeometry) {
    const auto hull = GeometryFixture::ofGeometry(
        "<convex_mesh convex_hull_of=\"#whole\"/></geometry>\n<geometry id=\"whole\"><mesh>" +
        vertices(kSquare) + "<triangles count=\"1\">" + kVertex + "<p>0 1 2</p></triangles></mesh>");

    EXPECT_THAT(hull.drawnPositions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(hull.said(), ElementsAre("WC0309:2"));
}

TEST(GeometryLoaderTest, aHullOfItselfIsRefused) {
    const auto hull = GeometryFixture::ofGeometry("<convex_mesh convex_hull_of=\"#shape\"/>");

    EXPECT_THAT(hull.mesh().parts, IsEmpty());
    EXPECT_THAT(hull.said(), ::testing::Contains("WC0206:2"));
}

TEST(GeometryLoaderTest, curvesAreNamedAsNotDrawn) {
    const auto curve = GeometryFixture::ofGeometry("\n<spline closed=\"true\"/>");

    EXPECT_THAT(curve.said(), ElementsAre("WC0308:3"));
    EXPECT_THAT(curve.diagnostics.all()[0].message, HasSubstr("<spline>"));
}

TEST(GeometryLoaderTest, aGeometryOfNothingIsAnError) {
    EXPECT_THAT(GeometryFixture::ofGeometry("").said(), ElementsAre("WC0203:1"));
}

}  // namespace
}  // namespace walkcycle
