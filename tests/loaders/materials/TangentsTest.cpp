#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "loaders/materials/Tangents.h"

namespace walkcycle {
namespace {

// The unit square in z = 0 with these texture coordinates.
MeshData square(const std::vector<glm::vec2>& coords) {
    MeshData mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.vertexPositions = {0, 1, 2, 3};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.texCoordSets.push_back({0, coords});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.parts.emplace_back();
    mesh.parts[0].indexCount = 6;
    return mesh;
}

TEST(TangentsTest, theTangentIsWhereUGrows) {
    MeshData mesh = square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    makeTangents(mesh, 0);
    for (const glm::vec4& tangent : mesh.tangents) EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
}

TEST(TangentsTest, aTurnedPictureTurnsTheTangent) {
    MeshData mesh = square({{0, 0}, {0, -1}, {1, -1}, {1, 0}});
    makeTangents(mesh, 0);
    for (const glm::vec4& tangent : mesh.tangents) EXPECT_EQ(tangent, glm::vec4(0, 1, 0, 1));
}

TEST(TangentsTest, aMirroredPictureHasTheOtherSign) {
    MeshData mesh = square({{0, 0}, {-1, 0}, {-1, 1}, {0, 1}});
    makeTangents(mesh, 0);
    for (const glm::vec4& tangent : mesh.tangents) EXPECT_EQ(tangent, glm::vec4(-1, 0, 0, -1));
}

TEST(TangentsTest, tangentsStandAtRightAnglesToTheNormal) {
    MeshData mesh = square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    mesh.normals.assign(4, glm::normalize(glm::vec3(1, 0, 1)));
    makeTangents(mesh, 0);
    for (const glm::vec4& t : mesh.tangents) {
        EXPECT_NEAR(glm::dot(glm::vec3(t), mesh.normals[0]), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::length(glm::vec3(t)), 1.0f, 1e-6f);
    }
}

TEST(TangentsTest, withoutAPictureAnyDirectionAlongTheSurfaceWillDo) {
    MeshData mesh = square({{0, 0}, {0, 0}, {0, 0}, {0, 0}});
    mesh.normals[1] = {1, 0, 0};
    makeTangents(mesh, 0);
    for (std::size_t v = 0; v < 4; ++v) {
        EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[v])), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[v]), mesh.normals[v]), 0.0f, 1e-6f);
    }
}

TEST(TangentsTest, linesHaveNone) {
    MeshData mesh = square({{0, 0}, {0, -1}, {1, -1}, {1, 0}});
    mesh.parts[0].indexCount = 3;
    mesh.parts.emplace_back();
    mesh.parts[1].primitive = Primitive::Lines;
    mesh.parts[1].firstIndex = 3;
    mesh.parts[1].indexCount = 2;
    makeTangents(mesh, 0);
    EXPECT_EQ(mesh.tangents.at(0), glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(mesh.tangents.at(3), glm::vec4(1, 0, 0, 1)) << "any will do where no triangle is";
}

}  // namespace
}  // namespace walkcycle
