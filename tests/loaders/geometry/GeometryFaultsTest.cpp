// What the geometry loader says about damaged primitives, where, and what it still shows.
#include <string>

#include <gmock/gmock.h>

#include "loaders/GeometryFixture.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kVertex = input("VERTEX", "verts", 0);

// Lines 3 and 4 are the sources, 5 the primitive's start tag and first input; `rest` begins in line 6.
GeometryFixture withTriangles(const std::string& rest, const std::string& count = "count=\"2\"") {
    return GeometryFixture(vertices(kSquare) + "<triangles " + count + ">" + kVertex + rest + "</triangles>");
}

TEST(GeometryFaultsTest, aFaceWithAPositionOutOfRangeIsLeftOut) {
    const auto mesh = withTriangles("<p>0 1\n7 0 2 3</p>");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 2, 3));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0301:7"));  // the line of the 7, not of <p>
    EXPECT_THAT(mesh.diagnostics.all()[0].elementPath, HasSubstr("triangles"));
    EXPECT_THAT(mesh.diagnostics.all()[0].message, HasSubstr("source of 4 entries; the first is 7"));
    EXPECT_THAT(mesh.mesh().positionUsed, ElementsAre(true, false, true, true));
    EXPECT_THAT(mesh.loaded.cornerVertices, ElementsAre(kNoVertex, kNoVertex, kNoVertex, 0, 1, 2));
}

TEST(GeometryFaultsTest, manyIndicesOutOfRangeAreToldOnce) {
    const auto mesh = withTriangles("<p>-1 8 9 5 6 7</p>");

    EXPECT_THAT(mesh.said(), ElementsAre("WC0301:6"));
    EXPECT_THAT(mesh.diagnostics.all()[0].message, HasSubstr("6 VERTEX indices"));
    EXPECT_THAT(mesh.mesh().parts, IsEmpty());
}

TEST(GeometryFaultsTest, aTextureCoordinateOutOfRangeIsZero) {
    const GeometryFixture mesh(vertices(kSquare) + source("uv", 2, "3 3 4 4 5 5") +
                               "<triangles count=\"1\">" + kVertex + input("TEXCOORD", "uv", 1) +
                               "<p>0 0 1 1 2 3</p></triangles>");

    EXPECT_EQ(mesh.mesh().texCoordSets.at(0).coords.at(2), glm::vec2(0));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0301:8"));
}

TEST(GeometryFaultsTest, aNormalOutOfRangeIsMade) {
    const GeometryFixture mesh(vertices(kSquare) + source("up", 3, "0 0 -1") + "<triangles count=\"1\">" +
                               kVertex + input("NORMAL", "up", 1) + "<p>0 0 1 0 2 9</p></triangles>");

    EXPECT_THAT(mesh.mesh().normals,
                ElementsAre(glm::vec3(0, 0, -1), glm::vec3(0, 0, -1), glm::vec3(0, 0, 1)));
    EXPECT_THAT(mesh.said(), ::testing::Contains("WC0301:8"));
}

TEST(GeometryFaultsTest, aNormalWithoutLengthIsMade) {
    const GeometryFixture mesh(vertices(kSquare) + source("up", 3, "0 0 0") + "<triangles count=\"1\">" +
                               kVertex + input("NORMAL", "up", 1) + "<p>0 0 1 0 2 0</p></triangles>");

    EXPECT_THAT(mesh.mesh().normals, ::testing::Each(glm::vec3(0, 0, 1)));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0310:6"));
    EXPECT_EQ(mesh.diagnostics.all()[0].severity, Severity::Info);
}

TEST(GeometryFaultsTest, anIndexThatIsNoNumberIsAnError) {
    const auto mesh = withTriangles("<p>0 1 2\n0 x 3</p>");

    EXPECT_THAT(mesh.said(), ::testing::Contains("WC0204:7"));
}

TEST(GeometryFaultsTest, aFaceCutShortIsLeftOut) {
    const auto mesh = withTriangles("<p>0 1 2 0 2</p>");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0302:6", "WC0205:5"));
}

TEST(GeometryFaultsTest, countsThatDisagreeAreErrorsAndDoNotMatter) {
    for (const char* count : {"1", "3", "0", "18446744073709551615"}) {
        const auto mesh = withTriangles("<p>0 1 2 0 2 3</p>", std::string("count=\"") + count + "\"");
        EXPECT_THAT(mesh.said(), ElementsAre("WC0205:5")) << count;
        EXPECT_EQ(mesh.mesh().indices.size(), 6u) << count;
    }
}

TEST(GeometryFaultsTest, countsThatAreNoNumbersAreErrorsAndDoNotMatter) {
    for (const char* count : {"", "abc", "-2", "0x2", "18446744073709551616"}) {
        const auto mesh = withTriangles("<p>0 1 2 0 2 3</p>", std::string("count=\"") + count + "\"");
        EXPECT_THAT(mesh.said(), ElementsAre("WC0204:5")) << count;
        EXPECT_EQ(mesh.mesh().indices.size(), 6u) << count;
    }
    EXPECT_THAT(withTriangles("<p>0 1 2 0 2 3</p>", "").said(), ElementsAre("WC0202:5"));
}

TEST(GeometryFaultsTest, nothingClaimedAndNothingHeldIsFine) {
    EXPECT_THAT(withTriangles("", "count=\"0\"").said(), IsEmpty());
}

// As above; <vcount> stands in line 6, <p> in line 7.
GeometryFixture withPolylist(const std::string& vcount, const std::string& count) {
    return GeometryFixture(vertices(kSquare) + "<polylist count=\"" + count + "\">" + kVertex + vcount +
                           "\n<p>0 1 2 0 2 3</p></polylist>");
}

TEST(GeometryFaultsTest, vcountThatWantsMoreThanThereIsShowsWhatFits) {
    const auto mesh = withPolylist("<vcount>3 4</vcount>", "2");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0303:6"));
}

TEST(GeometryFaultsTest, vcountThatWantsLessThanThereIsIsAnError) {
    EXPECT_THAT(withPolylist("<vcount>3</vcount>", "1").said(), ElementsAre("WC0303:6"));
}

TEST(GeometryFaultsTest, hugeAndNegativeVcountsCostNothing) {
    EXPECT_THAT(withPolylist("<vcount>2147483647 3</vcount>", "2").said(), ElementsAre("WC0303:6"));
    EXPECT_THAT(withPolylist("<vcount>-3 3 6</vcount>", "3").said(), ElementsAre("WC0303:6"));
}

TEST(GeometryFaultsTest, polygonsOfTwoCornersAreNotDrawn) {
    const auto mesh = withPolylist("<vcount>2 1 3</vcount>", "3");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 2, 3));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0304:6"));
}

TEST(GeometryFaultsTest, anIndexOutOfRangeIsToldInItsLineOfAFanOrAStrip) {
    for (const std::string kind : {"trifans", "tristrips", "linestrips"}) {
        const GeometryFixture mesh(vertices(kSquare) + "<" + kind + " count=\"2\">" + kVertex +
                                   "<p>0 1 2</p>\n<p>0 1\n2\n9</p></" + kind + ">");
        EXPECT_THAT(mesh.said(), ElementsAre("WC0301:9")) << kind;
    }
}

TEST(GeometryFaultsTest, aStripThatIsTooShortIsToldInItsLine) {
    const GeometryFixture mesh(vertices(kSquare) + "<tristrips count=\"2\">" + kVertex +
                               "<p>0 1 2</p>\n<p>0 1</p></tristrips>");
    EXPECT_THAT(mesh.said(), ElementsAre("WC0304:7"));
}

TEST(GeometryFaultsTest, aPolylistWithoutVcountIsAnError) {
    const auto mesh = withPolylist("", "2");

    EXPECT_THAT(mesh.mesh().parts, IsEmpty());
    EXPECT_THAT(mesh.said(), ::testing::Contains("WC0203:5"));
}

TEST(GeometryFaultsTest, aPrimitiveWithoutVerticesIsAnError) {
    const GeometryFixture mesh(vertices(kSquare) + "<triangles count=\"1\"><p>0 1 2</p></triangles>");

    EXPECT_THAT(mesh.said(), ElementsAre("WC0305:5"));
    EXPECT_EQ(mesh.mesh().positions.size(), 4u);
}

TEST(GeometryFaultsTest, verticesWithoutPositionsAreAnErrorToldOnce) {
    const GeometryFixture mesh("<vertices id=\"verts\"/><triangles count=\"1\">" + kVertex +
                               "<p>0 1 2</p></triangles>");

    EXPECT_THAT(mesh.said(), ElementsAre("WC0305:3"));
    EXPECT_EQ(mesh.diagnostics.all()[0].repeats, 0);
}

TEST(GeometryFaultsTest, aMeshWithoutVerticesIsAnError) {
    EXPECT_THAT(GeometryFixture("").said(), ElementsAre("WC0203:2"));
}

TEST(GeometryFaultsTest, aVertexInputThatNamesThePositionsIsUnderstood) {
    const GeometryFixture mesh(vertices(kSquare) + "<triangles count=\"1\">" + input("VERTEX", "pos", 0) +
                               "<p>0 1 2</p></triangles>");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0207:5"));
}

TEST(GeometryFaultsTest, aVertexInputThatLeadsNowhereMeansTheMeshsOwn) {
    const GeometryFixture mesh(vertices(kSquare) + "<triangles count=\"1\">" + input("VERTEX", "none", 0) +
                               "<p>0 1 2</p></triangles>");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0201:5"));
}

TEST(GeometryFaultsTest, brokenReferencesLeaveTheRestToSee) {
    const GeometryFixture mesh(vertices(kSquare) + "<triangles count=\"1\">" + kVertex +
                               input("NORMAL", "none", 1) + "<p>0 0 1 0 2 0</p></triangles>");

    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0201:6"));
    EXPECT_FALSE(mesh.loaded.hasNormals);
}

TEST(GeometryFaultsTest, sourcesOfOddWidthAreUsedAsFarAsTheyGo) {
    const GeometryFixture mesh(vertices(kSquare) + source("uv", 6, "1 2 3 4 5 6") +
                               "<triangles count=\"1\">" + kVertex + input("TEXCOORD", "uv", 1) +
                               "<p>0 0 1 0 2 0</p></triangles>");

    EXPECT_EQ(mesh.mesh().texCoordSets.at(0).coords.at(0), glm::vec2(1, 2));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0306:7"));
}

TEST(GeometryFaultsTest, textureCoordinateSetsHaveALimit) {
    std::string inputs;
    for (int i = 0; i < 33; ++i) inputs += input("TEXCOORD", "uv", 0);
    const GeometryFixture mesh(vertices(kSquare) + source("uv", 2, "0 0 1 0 1 1 0 1") +
                               "<triangles count=\"1\">" + kVertex + inputs + "<p>0 1 2</p></triangles>");

    EXPECT_EQ(mesh.mesh().texCoordSets.size(), 32u);
    EXPECT_THAT(mesh.said(), ElementsAre("WC0311:39"));
}

TEST(GeometryFaultsTest, facesWithoutAreaAreKeptAndCounted) {
    const GeometryFixture mesh(vertices("0 0 0 1 0 0 2 0 0 0 1 0") + "<triangles count=\"3\">" + kVertex +
                               "<p>0 1 2 0 1 3 1 1 3</p></triangles>");

    EXPECT_EQ(mesh.mesh().indices.size(), 9u);
    EXPECT_THAT(mesh.said(), ElementsAre("WC0307:5"));
    EXPECT_THAT(mesh.diagnostics.all()[0].message, HasSubstr("2 faces"));
    EXPECT_EQ(mesh.diagnostics.all()[0].severity, Severity::Info);
}

TEST(GeometryFaultsTest, aHoleWithABadCornerIsNoHole) {
    const GeometryFixture mesh(vertices("0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 3 1 0 3 3 0") +
                               "<polygons count=\"1\">" + kVertex +
                               "<ph><p>0 1 2 3</p><h>4 5 99</h></ph></polygons>");

    EXPECT_FLOAT_EQ(mesh.areaTowardsZ(), 16.0f);
    EXPECT_THAT(mesh.said(), ElementsAre("WC0301:6"));
}

}  // namespace
}  // namespace walkcycle
