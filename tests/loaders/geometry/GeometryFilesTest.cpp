// Whole documents of geometry, as the fixtures hold them.
#include <cmath>
#include <cstddef>
#include <string>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

#include "walkcycle/loaders/ColladaLoader.h"

namespace walkcycle {
namespace {

Model load(const std::string& name) {
    return loadCollada(WALKCYCLE_FIXTURES "/geometry-" + name + ".dae");
}

double areaOf(const MeshData& mesh) {
    double area = 0.0;
    const auto at = [&](std::size_t i) { return mesh.positions[mesh.vertexPositions[mesh.indices[i]]]; };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        area += 0.5 * glm::length(glm::cross(at(i + 1) - at(i), at(i + 2) - at(i)));
    return area;
}

TEST(GeometryFilesTest, everyKindOfPrimitiveDrawsTheSameSquare) {
    const Model model = load("primitives");

    EXPECT_THAT(model.diagnostics, ::testing::IsEmpty());
    ASSERT_EQ(model.meshes.size(), 7u);
    for (std::size_t m = 0; m < 5; ++m) EXPECT_DOUBLE_EQ(areaOf(model.meshes[m]), 1.0) << model.meshes[m].id;
    for (std::size_t m = 5; m < 7; ++m) {
        EXPECT_EQ(model.meshes[m].parts.at(0).primitive, Primitive::Lines) << model.meshes[m].id;
        EXPECT_EQ(model.meshes[m].indices.size(), 8u) << model.meshes[m].id;
    }
}

TEST(GeometryFilesTest, concavePolygonsAndHolesCoverTheirArea) {
    const Model model = load("concave");

    EXPECT_THAT(model.diagnostics, ::testing::IsEmpty());
    ASSERT_EQ(model.meshes.size(), 3u);
    EXPECT_NEAR(areaOf(model.meshes[0]), 10.6, 1e-5);                         // by the shoelace formula
    EXPECT_NEAR(areaOf(model.meshes[1]), 4.0 + 1.0 + 3.0 + 1.0 + 4.0, 1e-5);  // row by row, from below
    EXPECT_NEAR(areaOf(model.meshes[2]), 36.0 - 2.25 - 2.25 - 0.5, 1e-5);
    EXPECT_FLOAT_EQ(model.meshes[0].normals.at(0).z, 1.0f);
    EXPECT_FLOAT_EQ(model.meshes[2].normals.at(0).z, 1.0f);
}

}  // namespace
}  // namespace walkcycle
