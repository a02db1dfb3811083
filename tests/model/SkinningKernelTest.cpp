#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "model/SkinningKernel.h"

namespace walkcycle {
namespace {

// Points with any number of influences, under matrices of all kinds; and the plain formulas for them.
struct Cloud {
    std::vector<glm::mat4> palette;
    Influences influences;
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> vertexPositions;

    explicit Cloud(std::size_t count) {
        std::mt19937 engine(3);
        std::uniform_real_distribution<float> number(-1.0f, 1.0f);
        const auto vector = [&] { return glm::vec3(number(engine), number(engine), number(engine)); };
        for (int i = 0; i < 20; ++i) {
            const glm::mat4 rotated =
                glm::rotate(glm::mat4(1.0f), 3.0f * number(engine), glm::normalize(vector()));
            const glm::mat4 moved = glm::translate(rotated, vector());
            palette.push_back(i % 3 == 0 ? glm::scale(moved, {1.5f, 0.5f, i % 2 == 0 ? -1.0f : 1.0f})
                                         : moved);
        }
        influences.first = {0};
        for (std::size_t p = 0; p < count; ++p) {
            positions.push_back(vector());
            const std::size_t pulls = p % 7;
            for (std::size_t i = 0; i < pulls; ++i)
                influences.influences.push_back({static_cast<std::uint32_t>(engine() % palette.size()),
                                                 1.0f / static_cast<float>(pulls)});
            influences.first.push_back(static_cast<std::uint32_t>(influences.influences.size()));
            for (std::size_t corner = 0; corner <= p % 2; ++corner) {
                vertexPositions.push_back(static_cast<std::uint32_t>(p));
                normals.push_back(glm::normalize(vector()));
            }
        }
    }

    glm::mat4 blended(std::size_t p) const {
        glm::mat4 sum(0.0f);
        for (std::uint32_t i = influences.first[p]; i < influences.first[p + 1]; ++i)
            sum += palette[influences.influences[i].joint] * influences.influences[i].weight;
        return sum;
    }
};

void expectNear(const glm::vec3& actual, const glm::vec3& expected, const std::string& what) {
    EXPECT_LT(glm::distance(actual, expected), 2e-5f) << what;
}

class SkinningWays : public testing::TestWithParam<SkinningWay> {
protected:
    void SetUp() override {
        if (!hasSkinningWay(GetParam())) GTEST_SKIP() << "this processor cannot do that";
    }
};
INSTANTIATE_TEST_SUITE_P(Each, SkinningWays,
                         testing::Values(SkinningWay::Auto, SkinningWay::Baseline, SkinningWay::Avx2));

TEST_P(SkinningWays, positionsAreMovedByTheSumOfTheirMatrices) {
    for (const std::size_t count : {0u, 1u, 2u, 5u, 300u}) {
        const Cloud cloud(count);
        std::vector<glm::vec3> skinned(count);
        skinPositions(cloud.influences, cloud.palette, cloud.positions, skinned, nullptr, GetParam());
        for (std::size_t p = 0; p < count; ++p)
            expectNear(skinned[p], glm::vec3(cloud.blended(p) * glm::vec4(cloud.positions[p], 1.0f)),
                       "position " + std::to_string(p));
    }
}

TEST_P(SkinningWays, normalsFollowTheirSurface) {
    const Cloud cloud(301);
    std::vector<glm::vec3> positions = cloud.positions, normals = cloud.normals;
    std::vector<NormalMatrix> normalMatrices;
    skinPositions(cloud.influences, cloud.palette, positions, positions, &normalMatrices, GetParam());
    transformNormals(normalMatrices, cloud.vertexPositions, normals, normals, GetParam());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const std::size_t p = cloud.vertexPositions[v];
        const glm::mat3 matrix(cloud.blended(p));
        if (p % 7 == 0) {  // pulled by nothing: it shrinks to a point, which has no normal
            EXPECT_EQ(normals[v], glm::vec3(0.0f)) << v;
            continue;
        }
        expectNear(normals[v], glm::normalize(glm::transpose(glm::inverse(matrix)) * cloud.normals[v]),
                   "normal " + std::to_string(v));
        EXPECT_EQ(normalMatrices[p].isMirror(), glm::determinant(matrix) < 0.0f) << v;
    }
}

TEST_P(SkinningWays, whatIsTooLargeForANumberHasNoNormal) {
    Cloud cloud(8);
    for (glm::mat4& matrix : cloud.palette) matrix = glm::mat4(3e18f);
    std::vector<glm::vec3> positions = cloud.positions, normals = cloud.normals;
    std::vector<NormalMatrix> normalMatrices;
    skinPositions(cloud.influences, cloud.palette, positions, positions, &normalMatrices, GetParam());
    transformNormals(normalMatrices, cloud.vertexPositions, normals, normals, GetParam());
    for (const glm::vec3& normal : normals) EXPECT_EQ(normal, glm::vec3(0.0f));
}

}  // namespace
}  // namespace walkcycle
