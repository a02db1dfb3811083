#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include "loaders/GeometryFixture.h"
#include "loaders/controllers/MorphDeltas.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;

const std::string kVertex = input("VERTEX", "verts", 0);
const std::string kLowered = "0 0 0 1 0 -1 1 1 -1 0 1 0";  // the square, its right side lowered by one

std::string quad(const std::string& positions, const std::string& more = "") {
    return vertices(positions, more) + "<polylist count=\"1\">" + kVertex +
           "<vcount>4</vcount><p>0 1 2 3</p></polylist>";
}

// The square with normals of its own.
std::string litSquare() {
    return source("flat", 3, "0 0 1 0 0 1 0 0 1 0 0 1") +
           quad(kSquare, "<input semantic=\"NORMAL\" source=\"#flat\"/>");
}

TEST(MorphDeltasTest, normalizedTargetsAreDifferences) {
    const GeometryFixture base(quad(kSquare)), target(quad(kLowered));
    const MorphTarget morph = makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Normalized, "low");

    EXPECT_EQ(morph.id, "low");
    EXPECT_THAT(morph.positionDeltas,
                ElementsAre(glm::vec3(0), glm::vec3(0, 0, -1), glm::vec3(0, 0, -1), glm::vec3(0)));
}

TEST(MorphDeltasTest, relativeTargetsAreDifferencesAlready) {
    const GeometryFixture base(litSquare()), target(quad("0 0 0 0 0 -1 0 0 -1 0 0 0"));
    const MorphTarget morph = makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Relative, "low");

    EXPECT_EQ(morph.positionDeltas[2], glm::vec3(0, 0, -1));
    // The lowered square slopes by 45 degrees.
    const glm::vec3 slope = glm::normalize(glm::vec3(1, 0, 1));
    EXPECT_LT(glm::length(base.mesh().normals[0] + morph.normalDeltas[0] - slope), 1e-6f);
}

TEST(MorphDeltasTest, longerAndShorterTargetsMoveWhatTheyKnow) {
    const GeometryFixture base(quad(kSquare)), longer(quad(kLowered + " 7 7 7")), shorter(vertices("0 0 5"));

    EXPECT_EQ(makeMorphDeltas(base.loaded, longer.loaded, MorphMethod::Normalized, "").positionDeltas.size(),
              4u);
    EXPECT_THAT(makeMorphDeltas(base.loaded, shorter.loaded, MorphMethod::Normalized, "").positionDeltas,
                ElementsAre(glm::vec3(0, 0, 5), glm::vec3(0), glm::vec3(0), glm::vec3(0)));
}

TEST(MorphDeltasTest, targetsWithoutPrimitivesGetNormalsFromTheBasesPolygons) {
    const GeometryFixture base(litSquare()), target(vertices(kLowered));
    const MorphTarget morph = makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Normalized, "");

    const glm::vec3 slope = glm::normalize(glm::vec3(1, 0, 1));
    ASSERT_EQ(morph.normalDeltas.size(), 4u);
    for (std::size_t v = 0; v < 4; ++v)
        EXPECT_LT(glm::length(base.mesh().normals[v] + morph.normalDeltas[v] - slope), 1e-6f);
}

TEST(MorphDeltasTest, normalsOnVerticesAreTakenByPosition) {
    const std::string normals = source("up", 3, "0 0 1 1 0 0 0 1 0 0 0 1");
    const GeometryFixture base(litSquare()),
        target(normals + vertices(kLowered, "<input semantic=\"NORMAL\" source=\"#up\"/>"));
    const MorphTarget morph = makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Normalized, "");

    EXPECT_EQ(base.mesh().normals[1] + morph.normalDeltas[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(base.mesh().normals[2] + morph.normalDeltas[2], glm::vec3(0, 1, 0));
}

TEST(MorphDeltasTest, theTargetsOwnNormalsAreTakenCornerByCorner) {
    const auto withNormals = [](const std::string& positions, const std::string& normals) {
        return GeometryFixture(source("n", 3, normals) + vertices(positions) + "<polylist count=\"1\">" +
                               kVertex + input("NORMAL", "n", 1) +
                               "<vcount>4</vcount><p>0 0 1 1 2 2 3 3</p></polylist>");
    };
    const GeometryFixture base = withNormals(kSquare, "0 0 1 0 0 1 0 0 1 0 0 1");
    // Concave, so that it is cut otherwise than the base.
    const GeometryFixture target = withNormals("0 0 0 1 0 0 0.1 0.1 0 0 1 0", "0 0 1 0 1 0 1 0 0 0 0 1");
    const MorphTarget morph = makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Normalized, "");

    EXPECT_THAT(morph.normalDeltas,
                ElementsAre(glm::vec3(0), glm::vec3(0, 1, -1), glm::vec3(1, 0, -1), glm::vec3(0)));
}

TEST(MorphDeltasTest, aBaseWithoutNormalsNeedsNoneOfItsTargets) {
    const GeometryFixture base(quad(kSquare)), target(quad(kLowered));

    EXPECT_TRUE(
        makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Normalized, "").normalDeltas.empty());
}

TEST(MorphDeltasTest, everythingStaysFinite) {
    const GeometryFixture base(quad("-3e38 0 0 1 0 0 1 1 0 0 1 0")),
        target(quad("3e38 0 0 1 0 0 1 1 0 0 1 0"));
    const MorphTarget morph = makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Normalized, "");

    for (const glm::vec3& delta : morph.positionDeltas) EXPECT_TRUE(std::isfinite(delta.x));
    for (const glm::vec3& delta : morph.normalDeltas) EXPECT_TRUE(std::isfinite(delta.x + delta.y + delta.z));
}

// Each of the base's corners has a normal; the last one has a position that is not there, and lines have no normals.
std::string litWithLine(const std::string& p) {
    return source("n", 3, "0 0 1 0 1 0") + vertices(kSquare) + "<lines count=\"1\">" + kVertex +
           "<p>0 1</p></lines><triangles count=\"2\">" + kVertex + input("NORMAL", "n", 1) + "<p>" + p +
           "</p></triangles>";
}

TEST(MorphDeltasTest, cornersMissingInOneOfTheTwoKeepTheirNormals) {
    const GeometryFixture base(litWithLine("0 0 1 0 2 0 0 0 2 0 3 0")),
        lost(litWithLine("0 1 1 1 2 1 0 1 2 1 9 1"));
    const MorphTarget morph = makeMorphDeltas(base.loaded, lost.loaded, MorphMethod::Normalized, "");
    for (const glm::vec3& delta : morph.normalDeltas) EXPECT_EQ(delta, glm::vec3(0.0f)) << "polygons differ";
    const MorphTarget both = makeMorphDeltas(lost.loaded, lost.loaded, MorphMethod::Normalized, "");
    for (const glm::vec3& delta : both.normalDeltas) EXPECT_EQ(delta, glm::vec3(0.0f));
    const GeometryFixture complete(litWithLine("0 1 1 1 2 1 0 1 2 1 3 1"));
    const MorphTarget all = makeMorphDeltas(base.loaded, complete.loaded, MorphMethod::Normalized, "");
    EXPECT_EQ(all.normalDeltas[base.mesh().indices.back()], glm::vec3(0, 1, -1));
    EXPECT_EQ(all.normalDeltas[base.mesh().indices.front()], glm::vec3(0.0f)) << "of the line";
}

TEST(MorphDeltasTest, targetsOfOtherPolygonsGetNormalsFromTheirShape) {
    const GeometryFixture base(litWithLine("0 0 1 0 2 0 0 0 2 0 9 0")),
        fewer(source("n", 3, "0 0 1") + vertices(kLowered) + "<triangles count=\"1\">" + kVertex +
              input("NORMAL", "n", 1) + "<p>0 0 1 0 2 0</p></triangles>");
    const MorphTarget morph = makeMorphDeltas(base.loaded, fewer.loaded, MorphMethod::Normalized, "");
    const std::uint32_t vertex = base.loaded.cornerVertices.at(0);
    EXPECT_LT(glm::length(base.mesh().normals[vertex] + morph.normalDeltas[vertex] -
                          glm::normalize(glm::vec3(1, 0, 1))),
              1e-6f);
}

TEST(MorphDeltasTest, normalsByPositionLeaveLinesAlone) {
    const std::string normals = source("up", 3, "0 1 0 0 1 0 0 1 0 0 1 0");
    const GeometryFixture base(litWithLine("0 0 1 0 2 0 0 0 2 0 3 0")),
        target(normals + vertices(kLowered, "<input semantic=\"NORMAL\" source=\"#up\"/>"));
    const MorphTarget morph = makeMorphDeltas(base.loaded, target.loaded, MorphMethod::Normalized, "");
    EXPECT_EQ(morph.normalDeltas[base.mesh().indices.back()], glm::vec3(0, 1, -1));
    EXPECT_EQ(morph.normalDeltas[base.mesh().indices.front()], glm::vec3(0.0f));
}

}  // namespace
}  // namespace walkcycle
