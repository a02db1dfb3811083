#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <gmock/gmock.h>

#include "loaders/geometry/Triangulation.h"

namespace walkcycle {
namespace {

using ::testing::ElementsAre;
using Points = std::vector<glm::vec3>;

double area(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const double x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
    return (x1 * y2 - x2 * y1) / 2;
}

double areaOf(const Points& points, std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin + 1; i + 1 < end; ++i) sum += area(points[begin], points[i], points[i + 1]);
    return sum;
}

struct Covered {
    double area = 0.0;
    bool anyReversed = false;
    std::size_t triangles = 0;
};

Covered cover(const Points& points, const std::vector<std::uint32_t>& ringEnds) {
    Triangulation triangulation;
    Covered covered;
    const std::vector<std::uint32_t>& triangles = triangulation.cut(points, ringEnds);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const double a = area(points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]);
        covered.area += a;
        covered.anyReversed = covered.anyReversed || a < -1e-9;
    }
    covered.triangles = triangles.size() / 3;
    return covered;
}

// No triangle reversed and the areas equal: nothing is outside, nothing twice, nothing forgotten.
void expectExactCover(const Points& points, const std::vector<std::uint32_t>& ringEnds) {
    double expected = std::abs(areaOf(points, 0, ringEnds[0]));
    for (std::size_t r = 1; r < ringEnds.size(); ++r)
        expected -= std::abs(areaOf(points, ringEnds[r - 1], ringEnds[r]));
    const Covered covered = cover(points, ringEnds);
    EXPECT_NEAR(covered.area, expected, 1e-5 * expected);
    EXPECT_FALSE(covered.anyReversed);
    EXPECT_EQ(covered.triangles, points.size() - 2 + 2 * (ringEnds.size() - 1));
}

Points star(std::size_t corners, std::uint32_t seed, float least) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> radius(least, 1.0f);
    Points points;
    for (std::size_t i = 0; i < corners; ++i) {
        const float angle =
            2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(corners);
        const float r = radius(random);
        points.push_back({r * std::cos(angle), r * std::sin(angle), 0.0f});
    }
    return points;
}

TEST(TriangulationTest, aConvexPolygonIsAFan) {
    const Points hexagon{{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
    EXPECT_THAT(Triangulation().cut(hexagon, std::vector<std::uint32_t>{6}),
                ElementsAre(0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5));
}

TEST(TriangulationTest, anArrowHeadIsCutAtItsNotch) {
    expectExactCover({{0, 0, 0}, {2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}}, {4});
    expectExactCover({{2, -1, 0}, {0.5f, 0, 0}, {2, 1, 0}, {0, 0, 0}}, {4});
}

TEST(TriangulationTest, itLooksFromWhereThePolygonFaces) {
    const Points points{{0, 0, 0}, {0, 0, 2}, {0, 0.5f, 0.5f}, {0, 2, 0}};  // in the plane x = 0, facing -x
    const std::vector<std::uint32_t> triangles = Triangulation().cut(points, std::vector<std::uint32_t>{4});
    ASSERT_EQ(triangles.size(), 6u);
    for (std::size_t i = 0; i < 6; i += 3) {
        const glm::vec3 a = points[triangles[i]], b = points[triangles[i + 1]], c = points[triangles[i + 2]];
        EXPECT_LT((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y), 0.0f);
    }
}

TEST(TriangulationTest, cornersOnAnEdgeDoNotMakeTrianglesWithoutArea) {
    const Points points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}};
    const std::vector<std::uint32_t> triangles = Triangulation().cut(points, std::vector<std::uint32_t>{6});
    ASSERT_EQ(triangles.size(), 12u);
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        EXPECT_GT(area(points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]), 0.0);
}

TEST(TriangulationTest, starsOfAllSizesAreCoveredExactly) {
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        const Points points = star(4 + seed % 60, seed, 0.2f);
        expectExactCover(points, {static_cast<std::uint32_t>(points.size())});
    }
}

TEST(TriangulationTest, aCombIsCoveredExactly) {
    Points points{{0, 0, 0}, {200, 0, 0}};
    for (int tooth = 199; tooth >= 0; --tooth) {
        points.push_back({static_cast<float>(tooth) + 0.9f, 5, 0});
        points.push_back({static_cast<float>(tooth) + 0.1f, 1, 0});
    }
    expectExactCover(points, {static_cast<std::uint32_t>(points.size())});
}

TEST(TriangulationTest, holesOfEitherDirectionAreLeftOpen) {
    Points points{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
    points.insert(points.end(), {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}});  // turns as the outline does
    points.insert(points.end(), {{5, 1, 0}, {5, 2, 0}, {6, 2, 0}, {6, 1, 0}});  // turns the other way
    points.insert(points.end(), {{3, 6, 0}, {4, 5, 0}, {5, 6, 0}});
    expectExactCover(points, {4, 8, 12, 15});
}

TEST(TriangulationTest, aGridOfHolesIsLeftOpen) {
    Points points{{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}};
    std::vector<std::uint32_t> ends{4};
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) {
            const glm::vec3 at(2 * x + 1, 2 * y + 1, 0);  // many holes share a height, and bridges their ends
            points.insert(points.end(), {at - glm::vec3(0.5f, 0, 0), at - glm::vec3(0, 0.5f, 0),
                                         at + glm::vec3(0.5f, 0, 0), at + glm::vec3(0, 0.5f, 0)});
            ends.push_back(static_cast<std::uint32_t>(points.size()));
        }
    expectExactCover(points, ends);
}

TEST(TriangulationTest, holesInAStarAreLeftOpen) {
    for (std::uint32_t seed = 0; seed < 50; ++seed) {
        SCOPED_TRACE(seed);
        Points points = star(40, seed, 0.6f);
        std::vector<std::uint32_t> ends{40};
        for (int hole = 0; hole < 4; ++hole) {
            const glm::vec3 at(0.25f * static_cast<float>(hole % 2 * 2 - 1),
                               0.25f * static_cast<float>(hole / 2 * 2 - 1), 0);
            for (const glm::vec3& p : star(9, seed * 4 + static_cast<std::uint32_t>(hole) + 1000, 0.3f))
                points.push_back(at + 0.15f * p);
            ends.push_back(static_cast<std::uint32_t>(points.size()));
        }
        expectExactCover(points, ends);
    }
}

TEST(TriangulationTest, whatHasNoAreaOrCrossesItselfIsStillCut) {
    EXPECT_EQ(cover({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {4}).triangles, 2u);
    EXPECT_EQ(cover({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {5}).triangles, 3u);
    EXPECT_EQ(cover({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {4}).triangles, 2u);
    Points pentagram;
    for (int i = 0; i < 5; ++i) {
        const float angle = 4.0f * std::numbers::pi_v<float> * static_cast<float>(i) / 5.0f;
        pentagram.push_back({std::cos(angle), std::sin(angle), 0.0f});
    }
    EXPECT_EQ(cover(pentagram, {5}).triangles, 3u);
}

TEST(TriangulationTest, aHoleOutsideItsPolygonDoesNoHarm) {
    const Points points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 0}, {6, 5, 0}, {6, 6, 0}};
    EXPECT_NEAR(cover(points, {4, 7}).area, 1.0, 1e-6);
}

double secondsFor(const Points& points, const std::vector<std::uint32_t>& ends) {
    const auto start = std::chrono::steady_clock::now();
    cover(points, ends);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(TriangulationTest, aHundredThousandCornersDoNotHang) {
    const Points jagged = star(100'000, 7, 0.2f);
    EXPECT_LT(secondsFor(jagged, {100'000}), 60.0);  // a hang, on however busy a machine

    std::mt19937 random(3);
    std::uniform_real_distribution<float> anywhere(0.0f, 1.0f);
    Points tangle;
    for (int i = 0; i < 100'000; ++i) tangle.push_back({anywhere(random), anywhere(random), 0.0f});
    EXPECT_LT(secondsFor(tangle, {100'000}), 60.0);
}

TEST(TriangulationTest, aHonestHugeOutlineIsCoveredExactly) {
    const Points coast = star(100'000, 11, 0.98f);
    expectExactCover(coast, {100'000});
}

}  // namespace
}  // namespace walkcycle
