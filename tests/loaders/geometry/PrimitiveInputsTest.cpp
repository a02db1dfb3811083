#include <string>

#include <gmock/gmock.h>

#include "loaders/GeometryFixture.h"
#include "loaders/geometry/PrimitiveInputs.h"

namespace walkcycle {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kVertex = input("VERTEX", "verts", 0);

// One triangle with those inputs; `sources` go before <vertices>.
GeometryFixture with(const std::string& inputs, const std::string& sources = "", const std::string& more = "",
                     const std::string& p = "0 1 2") {
    return GeometryFixture(sources + vertices(kSquare, more) + "<triangles count=\"1\">\n" + inputs + "<p>" +
                           p + "</p></triangles>");
}

TEST(PrimitiveInputsTest, anInputThatLeadsToNoSourceIsReportedAndLeftOut) {
    const GeometryFixture mesh = with(kVertex + input("NORMAL", "verts", 0));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0207:7"));
    EXPECT_THAT(mesh.diagnostics.all()[0].message,
                HasSubstr("'#verts', which is a <vertices>, not a <source>"));
    EXPECT_FALSE(mesh.loaded.hasNormals);
    const GeometryFixture textured = with(kVertex + input("TEXCOORD", "verts", 0));
    EXPECT_THAT(textured.said(), ElementsAre("WC0207:7"));
    EXPECT_THAT(textured.mesh().texCoordSets, IsEmpty());
}

TEST(PrimitiveInputsTest, ofTwoInputsOfOneKindTheFirstCounts) {
    const std::string sources = source("up", 3, "0 0 1") + source("down", 3, "0 0 -1") +
                                source("red", 3, "1 0 0") + source("blue", 3, "0 0 1") +
                                source("far", 3, "9 9 9 9 9 9 9 9 9");
    const GeometryFixture mesh =
        with(kVertex + input("NORMAL", "up", 1) + input("NORMAL", "down", 1) + input("COLOR", "red", 1) +
                 input("COLOR", "blue", 1),
             sources, "<input semantic=\"POSITION\" source=\"#far\"/>", "0 0 1 0 2 0");
    EXPECT_THAT(mesh.mesh().normals, Each(glm::vec3(0, 0, 1)));
    EXPECT_THAT(mesh.mesh().colors, Each(glm::vec4(1, 0, 0, 1)));
    EXPECT_EQ(mesh.mesh().positions.at(1), glm::vec3(1, 0, 0));
}

TEST(PrimitiveInputsTest, aPrimitiveMayNameItsPositionsItself) {
    const GeometryFixture mesh = with(input("POSITION", "pos", 0));
    EXPECT_THAT(mesh.said(), IsEmpty());
    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
    const GeometryFixture neither = with(input("NORMAL", "pos", 0));
    EXPECT_THAT(neither.said(), Contains("WC0305:5"));
    EXPECT_THAT(neither.drawnPositions(), IsEmpty());
}

TEST(PrimitiveInputsTest, aVertexInputThatNamesThePositionsThemselvesIsClear) {
    const GeometryFixture mesh = with(input("VERTEX", "pos", 0));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0207:6"));
    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
    const GeometryFixture twice = with(input("POSITION", "pos", 0) + input("VERTEX", "pos", 0));
    EXPECT_THAT(twice.said(), ElementsAre("WC0207:7"));
    EXPECT_THAT(twice.drawnPositions(), ElementsAre(0, 1, 2));
}

TEST(PrimitiveInputsTest, aVertexInputThatLeadsToAnythingElseDrawsNothing) {
    const GeometryFixture mesh = with(input("VERTEX", "shape", 0));
    EXPECT_THAT(mesh.said(), ElementsAre("WC0207:6"));
    EXPECT_THAT(mesh.diagnostics.all()[0].message, HasSubstr("which is a <geometry>, not a <vertices>"));
    EXPECT_THAT(mesh.drawnPositions(), IsEmpty());
}

TEST(PrimitiveInputsTest, theVerticesOfAnotherMeshAreThose) {
    const GeometryFixture mesh = GeometryFixture::ofGeometry(
        "<mesh>\n" + vertices(kSquare) + "<triangles count=\"1\">" + input("VERTEX", "theirs", 0) +
        "<p>0 1 2</p></triangles></mesh></geometry><geometry id=\"other\"><mesh>" +
        source("far", 3, "9 0 0 9 1 0 9 1 1") +
        "<vertices id=\"theirs\"><input semantic=\"POSITION\" source=\"#far\"/></vertices></mesh>");
    EXPECT_THAT(mesh.said(), IsEmpty());
    ASSERT_THAT(mesh.mesh().indices, SizeIs(3));
    EXPECT_EQ(mesh.mesh().positions.at(mesh.drawnPositions()[2]), glm::vec3(9, 1, 1));
}

TEST(PrimitiveInputsTest, anOffsetThatIsNoNumberIsAnErrorAndCountsAsZero) {
    std::string vertex = kVertex;
    vertex.replace(vertex.find("\"0\""), 3, "\"x\"");
    const GeometryFixture mesh = with(vertex);
    EXPECT_THAT(mesh.said(), ElementsAre("WC0204:6"));
    EXPECT_THAT(mesh.drawnPositions(), ElementsAre(0, 1, 2));
}

TEST(PrimitiveInputsTest, normalsOfVerticesWithoutPositionsDrawNothing) {
    const GeometryFixture mesh(
        source("up", 3, "0 0 1") +
        "<vertices id=\"verts\"><input semantic=\"NORMAL\" source=\"#up\"/></vertices>\n"
        "<triangles count=\"1\">" +
        kVertex + "<p>0 0 0</p></triangles>");
    EXPECT_THAT(mesh.said(), ElementsAre("WC0305:4"));
    EXPECT_THAT(mesh.mesh().parts, IsEmpty());
    EXPECT_THAT(mesh.loaded.positionNormals, IsEmpty());
}

TEST(PrimitiveInputsTest, aNormalOfAnyLengthIsBroughtToOne) {
    const GeometryFixture mesh =
        with(kVertex + input("NORMAL", "n", 1), source("n", 3, "0 0 1e20 0 0 5 0 0 1e-7"), "", "0 0 1 1 2 2");
    EXPECT_THAT(mesh.mesh().normals, Each(glm::vec3(0, 0, 1)));
}

TEST(PrimitiveInputsTest, coloursMayHaveAnAlphaOfTheirOwn) {
    const GeometryFixture mesh =
        with(kVertex + input("COLOR", "c", 1), source("c", 4, "1 0 0 0.5"), "", "0 0 1 0 2 -1");
    EXPECT_EQ(mesh.mesh().colors.at(0), glm::vec4(1, 0, 0, 0.5f));
    EXPECT_EQ(mesh.mesh().colors.at(2), glm::vec4(1.0f)) << "what is out of range is white";
    EXPECT_THAT(mesh.said(), ElementsAre("WC0301:9"));
}

TEST(PrimitiveInputsTest, primitivesShareTheSetsOfTextureCoordinates) {
    const std::string triangles =
        "<triangles count=\"1\">" + kVertex + input("TEXCOORD", "uv", 0) + "<p>0 1 2</p></triangles>";
    const GeometryFixture mesh(source("uv", 2, "0 0 1 0 1 1") + source("red", 3, "1 0 0 1 0 0 1 0 0") +
                               vertices(kSquare) + triangles + triangles);
    EXPECT_THAT(mesh.mesh().texCoordSets, SizeIs(1));
    EXPECT_THAT(mesh.mesh().indices, SizeIs(6));
    EXPECT_EQ(mesh.mesh().vertexCount(), 3u);
}

TEST(PrimitiveInputsTest, doubleSidedIsReadFromTheExtraThatSaysIt) {
    const auto sided = [](const std::string& extra) {
        return GeometryFixture::ofGeometry("<mesh>" + vertices(kSquare) + "</mesh><extra>" + extra +
                                           "</extra>")
            .mesh()
            .doubleSided;
    };
    EXPECT_TRUE(
        sided("<technique profile=\"MAX3D\"/><technique profile=\"MAYA\"><double_sided>1</double_sided>"
              "</technique>"));
    EXPECT_FALSE(sided("<technique profile=\"MAYA\"><double_sided>0</double_sided></technique>"));
    EXPECT_FALSE(sided("<technique profile=\"MAYA\"><double_sided>yes</double_sided></technique>"));
}

TEST(PrimitiveInputsTest, aHullOfAHullIsShownAsTheMeshAndSaidOnce) {
    const std::string mesh = "<mesh>" + vertices(kSquare) + "<triangles count=\"1\">" + kVertex +
                             "<p>0 1 2</p></triangles></mesh></geometry>";
    const GeometryFixture hull = GeometryFixture::ofGeometry(
        "<convex_mesh convex_hull_of=\"#b\"/></geometry><geometry id=\"b\"><convex_mesh "
        "convex_hull_of=\"#c\"/>"
        "</geometry><geometry id=\"c\">" +
        mesh + "<geometry id=\"d\">");
    EXPECT_THAT(hull.said(), ElementsAre("WC0309:2"));
    EXPECT_THAT(hull.drawnPositions(), ElementsAre(0, 1, 2));
    const GeometryFixture gone = GeometryFixture::ofGeometry("<convex_mesh convex_hull_of=\"#none\"/>");
    EXPECT_THAT(gone.said(), ElementsAre("WC0201:2"));
    EXPECT_THAT(gone.mesh().indices, IsEmpty());
}

}  // namespace
}  // namespace walkcycle
