#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/LoadText.h"
#include "loaders/geometry/MeshBuilder.h"

namespace walkcycle {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::SizeIs;

std::shared_ptr<const FloatSource> sourceOf(std::vector<float> values) {
    auto source = std::make_shared<FloatSource>();
    source->values = std::move(values);
    source->width = 3;
    return source;
}

// The unit square and a point beside it.
const std::vector<float> kPositions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0};

// Primitives without a file: polygons of so many indices per corner, the position's first and the normal's second.
class MeshBuilderTest : public testing::Test {
protected:
    using Polygons = std::initializer_list<std::vector<std::int32_t>>;

    PrimitiveCorners primitive(Polygons polygons, std::vector<float> normals = {}) {
        PrimitiveCorners made;
        made.element = load.collada.child("triangles");
        made.inputs.position.source = positions;
        made.inputs.stride = normals.empty() ? 1 : 2;
        if (!normals.empty()) {
            made.inputs.normal.source = sourceOf(std::move(normals));
            made.inputs.normal.offset = 1;
        }
        for (const std::vector<std::int32_t>& polygon : polygons) {
            made.rings.push_back({static_cast<std::uint32_t>(made.cornerCount()),
                                  static_cast<std::uint32_t>(polygon.size() / made.inputs.stride), false});
            made.indices.insert(made.indices.end(), polygon.begin(), polygon.end());
        }
        return made;
    }

    const MeshData& build(const std::vector<PrimitiveCorners>& primitives) {
        PrimitiveInputs vertices;
        vertices.position.source = positions;
        buildMesh(vertices, primitives, loaded, load.context);
        return loaded.mesh;
    }

    // The positions of the indices, in drawing order.
    std::vector<std::uint32_t> drawn() const {
        std::vector<std::uint32_t> all;
        for (const std::uint32_t vertex : loaded.mesh.indices)
            all.push_back(loaded.mesh.vertexPositions[vertex]);
        return all;
    }

    std::vector<std::uint32_t> triangle(std::size_t firstIndex) const {
        const std::vector<std::uint32_t> all = drawn();
        return {all.begin() + static_cast<std::ptrdiff_t>(firstIndex),
                all.begin() + static_cast<std::ptrdiff_t>(firstIndex) + 3};
    }

    TestLoad load{"<COLLADA><triangles/></COLLADA>"};
    std::shared_ptr<const FloatSource> positions = sourceOf(kPositions);
    LoadedMesh loaded;
};

TEST_F(MeshBuilderTest, cornersThatAreAlikeAreOneVertex) {
    const MeshData& mesh = build({primitive({{0, 0, 1, 0, 2, 0}, {0, 0, 2, 0, 3, 0}}, {0, 0, 1})});
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_THAT(mesh.vertexPositions, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(mesh.normals, Each(isAt(0, 0, 1)));
}

TEST_F(MeshBuilderTest, aPositionWithTwoNormalsIsTwoVertices) {
    const MeshData& mesh = build({primitive({{0, 0, 1, 0, 2, 0}, {0, 1, 2, 1, 3, 1}}, {0, 0, 1, 1, 0, 0})});
    EXPECT_THAT(drawn(), ElementsAre(0, 1, 2, 0, 2, 3));
    EXPECT_EQ(mesh.vertexCount(), 6u);
    EXPECT_THAT(mesh.normals[mesh.indices[3]], isAt(1, 0, 0));
    EXPECT_TRUE(loaded.hasNormals);
    EXPECT_THAT(loaded.indexCorners, IsEmpty()) << "only meshes whose normals are made need them";
}

TEST_F(MeshBuilderTest, aQuadIsCutWhereBothTrianglesFaceAsItDoes) {
    build({primitive({{0, 1, 2, 3}})});
    EXPECT_THAT(drawn(), ElementsAre(0, 1, 2, 0, 2, 3));

    // A dart whose inner corner is the second: both triangles must have it, and the one opposite.
    positions = sourceOf({0, 0, 0, 0.4f, 0.4f, 0, 2, 0, 0, 0, 2, 0});
    loaded = {};
    build({primitive({{0, 1, 2, 3}})});
    ASSERT_THAT(drawn(), SizeIs(6));
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}})
        EXPECT_THAT(triangle(first), IsSupersetOf({1u, 3u}));
}

TEST_F(MeshBuilderTest, aFaceWithoutOneOfItsPositionsIsLeftOutAndTold) {
    const MeshData& mesh = build({primitive({{0, 1, 2}, {0, 2, 7}, {0, 2, -1}})});
    EXPECT_THAT(drawn(), ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.positionUsed, ElementsAre(true, true, true, false, false));
    EXPECT_THAT(loaded.cornerVertices,
                ElementsAre(0, 1, 2, kNoVertex, kNoVertex, kNoVertex, kNoVertex, kNoVertex, kNoVertex));
    EXPECT_THAT(codes(load.diagnostics.all()), ElementsAre("WC0301"));
}

TEST_F(MeshBuilderTest, madeNormalsKnowTheCornerOfEachIndex) {
    PrimitiveCorners lines = primitive({{3, 4}});
    lines.kind = Primitive::Lines;
    const MeshData& mesh = build({primitive({{1, 2, 0}}), lines});
    EXPECT_FALSE(loaded.hasNormals);
    EXPECT_THAT(loaded.indexCorners, ElementsAre(0, 1, 2, kNoCorner, kNoCorner));
    EXPECT_THAT(mesh.normals[mesh.indices[0]], isAt(0, 0, 1));
    EXPECT_THAT(mesh.normals[mesh.indices[3]], isAt(0, 0, 0)) << "lines have none";
    EXPECT_THAT(mesh.positionUsed, ElementsAre(true, true, true, false, false)) << "lines are no surface";
}

TEST_F(MeshBuilderTest, eachPrimitiveIsAPartAndAnEmptyOneIsNone) {
    const MeshData& mesh = build({primitive({{0, 1, 2}}), primitive({}), primitive({{0, 2, 3}, {1, 4, 2}})});
    ASSERT_THAT(mesh.parts, SizeIs(2));
    EXPECT_EQ(mesh.parts[0].indexCount, 3u);
    EXPECT_EQ(mesh.parts[1].firstIndex, 3u);
    EXPECT_EQ(mesh.parts[1].indexCount, 6u);
}

TEST_F(MeshBuilderTest, facesOfTwoPartsAreSmoothTogether) {
    // The second square is bent down by 37 degrees about the edge that both share.
    positions = sourceOf({-1, 0, 0, 0, 0, 0, 0, 1, 0, -1, 1, 0, 0.8f, 0, -0.6f, 0.8f, 1, -0.6f});
    const MeshData& mesh = build({primitive({{0, 1, 2, 3}}), primitive({{1, 4, 5, 2}})});
    EXPECT_EQ(mesh.vertexCount(), 6u);
    EXPECT_GT(mesh.normals[1].x, 0.1f);
    EXPECT_GT(mesh.normals[1].z, 0.1f);
}

TEST_F(MeshBuilderTest, aSecondSourceOfPositionsStandsBehindTheFirst) {
    PrimitiveCorners other = primitive({{0, 1, 2}});
    other.inputs.position.source = sourceOf({5, 0, 0, 6, 0, 0, 6, 1, 0});
    const MeshData& mesh = build({primitive({{0, 1, 2}}), other});
    EXPECT_THAT(mesh.positions, SizeIs(8));
    EXPECT_THAT(drawn(), ElementsAre(0, 1, 2, 5, 6, 7));
    EXPECT_THAT(mesh.positions[5], isAt(5, 0, 0));
}

TEST_F(MeshBuilderTest, aHoleIsCutOut) {
    PrimitiveCorners ring = primitive({{0, 1, 2, 3}, {4, 5, 6}});
    ring.rings[1].hole = true;
    positions = sourceOf({0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 1, 1, 0, 1, 2, 0, 2, 1, 0});
    ring.inputs.position.source = positions;
    build({ring});
    float area = 0.0f;
    for (std::size_t i = 0; i + 2 < drawn().size(); i += 3) {
        const glm::vec3 a = loaded.mesh.positions[drawn()[i]];
        area +=
            glm::cross(loaded.mesh.positions[drawn()[i + 1]] - a, loaded.mesh.positions[drawn()[i + 2]] - a)
                .z /
            2;
    }
    EXPECT_NEAR(area, 15.5f, 1e-4f);
}

TEST_F(MeshBuilderTest, facesWithoutAreaStayAndAreTold) {
    build({primitive({{0, 1, 4}, {0, 1, 2}})});
    EXPECT_THAT(drawn(), ElementsAre(0, 1, 4, 0, 1, 2));
    EXPECT_THAT(codes(load.diagnostics.all()), ElementsAre("WC0307"));
}

}  // namespace
}  // namespace walkcycle
