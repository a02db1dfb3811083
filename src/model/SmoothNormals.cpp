#include "model/SmoothNormals.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include <glm/geometric.hpp>

namespace walkcycle {
namespace {

// If more corners than this meet, all of them are smoothed together: comparing each pair would take too long.
constexpr std::size_t kMostComparedFaces = 256;

using Share = SmoothNormals::Share;

glm::dvec3 areaVector(const MeshFaces& faces, const Ring& ring, const std::vector<glm::vec3>& positions) {
    const std::uint32_t* corners = faces.cornerPositions.data() + ring.firstCorner;
    const glm::dvec3 origin(positions[corners[0]]);
    glm::dvec3 area(0.0);
    glm::dvec3 edge = glm::dvec3(positions[corners[1]]) - origin;
    for (std::uint32_t i = 2; i < ring.cornerCount; ++i) {
        const glm::dvec3 next = glm::dvec3(positions[corners[i]]) - origin;
        area += glm::cross(edge, next);
        edge = next;
    }
    return area;
}

// The interior angle of the polygon at a corner; over 180 degrees if the corner is reflex.
float innerAngle(const glm::dvec3& before, const glm::dvec3& at, const glm::dvec3& after,
                 const glm::vec3& normal) {
    const glm::dvec3 in = at - before, out = after - at;
    const glm::dvec3 perpendicular = glm::cross(in, out);
    const double angle = std::atan2(glm::length(perpendicular), -glm::dot(in, out));
    return static_cast<float>(
        glm::dot(perpendicular, glm::dvec3(normal)) < 0.0 ? 2.0 * std::numbers::pi - angle : angle);
}

void addShares(const MeshFaces& faces, const Ring& ring, const glm::vec3& restNormal, const glm::vec3& normal,
               const std::vector<glm::vec3>& positions, std::vector<Share>& shares) {
    const auto at = [&](std::uint32_t i) {
        return glm::dvec3(positions[faces.cornerPositions[ring.firstCorner + i % ring.cornerCount]]);
    };
    for (std::uint32_t i = 0; i < ring.cornerCount; ++i) {
        const float angle = innerAngle(at(i + ring.cornerCount - 1), at(i), at(i + 1), normal);
        shares[ring.firstCorner + i] = {restNormal, angle * normal};
    }
}

bool isWhole(const MeshFaces& faces, const Ring& ring) {
    const auto first = faces.cornerPositions.begin() + ring.firstCorner;
    return std::find(first, first + ring.cornerCount, kNoPosition) == first + ring.cornerCount;
}

void findShares(const MeshFaces& faces, const std::vector<glm::vec3>& rest,
                const std::vector<glm::vec3>& deformed, std::vector<Share>& shares) {
    shares.assign(faces.cornerPositions.size(), {});
    glm::vec3 restNormal(0.0f), normal(0.0f);
    for (const Ring& ring : faces.rings) {
        if (!isWhole(faces, ring)) continue;
        if (!ring.hole) {  // a hole has its outline's normal
            restNormal = unitOrZero(areaVector(faces, ring, rest));
            normal = &rest == &deformed ? restNormal : unitOrZero(areaVector(faces, ring, deformed));
        }
        addShares(faces, ring, restNormal, normal, deformed, shares);
    }
}

// Per position: the index of the first position with the same value. Otherwise, positions that exporters
// repeat would make hard edges.
std::vector<std::uint32_t> firstOfEqual(const std::vector<glm::vec3>& positions) {
    constexpr std::uint32_t kEmpty = ~std::uint32_t{0};
    std::vector<std::uint32_t> table(std::bit_ceil(positions.size() * 2 + 1), kEmpty),
        first(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis)
            hash = (hash ^ std::bit_cast<std::uint32_t>(positions[i][axis] + 0.0f)) * 0x9E3779B97F4A7C15ull;
        std::size_t slot = (hash >> 32) & (table.size() - 1);
        while (table[slot] != kEmpty && positions[table[slot]] != positions[i])
            slot = (slot + 1) & (table.size() - 1);
        if (table[slot] == kEmpty) table[slot] = i;
        first[i] = table[slot];
    }
    return first;
}

void setNormal(glm::vec3& normal, const glm::dvec3& sum) {
    const glm::vec3 unit = unitOrZero(sum);
    if (unit != glm::vec3(0.0f)) normal = unit;
}

void smoothAll(std::span<const std::uint32_t> corners, const std::vector<Share>& shares,
               std::vector<glm::vec3>& normals) {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t corner : corners) sum += glm::dvec3(shares[corner].weighted);
    for (const std::uint32_t corner : corners) setNormal(normals[corner], sum);
}

void smoothWithinCrease(std::span<const std::uint32_t> corners, const std::vector<Share>& shares,
                        std::vector<glm::vec3>& normals) {
    static const float cosCrease = std::cos(kCreaseAngleDegrees * std::numbers::pi_v<float> / 180.0f);
    for (const std::uint32_t corner : corners) {
        const glm::vec3& own = shares[corner].creaseNormal;
        glm::dvec3 sum(0.0);
        for (const std::uint32_t other : corners) {
            // A face without an area has no direction: it takes the normal of its neighbours.
            if (own == glm::vec3(0.0f) || glm::dot(own, shares[other].creaseNormal) >= cosCrease)
                sum += glm::dvec3(shares[other].weighted);
        }
        setNormal(normals[corner], sum);
    }
}

}  // namespace

glm::vec3 unitOrZero(const glm::dvec3& vector) {
    const double length = glm::length(vector);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(vector / length) : glm::vec3(0.0f);
}

CornerGroups groupCorners(const MeshFaces& faces, const std::vector<glm::vec3>& positions) {
    const std::vector<std::uint32_t> first = firstOfEqual(positions);
    CornerGroups groups;
    groups.starts.assign(positions.size() + 2, 0);
    for (const std::uint32_t position : faces.cornerPositions)
        if (position != kNoPosition) ++groups.starts[first[position] + 2];
    for (std::size_t i = 2; i < groups.starts.size(); ++i) groups.starts[i] += groups.starts[i - 1];
    groups.corners.resize(groups.starts.back());
    for (std::uint32_t c = 0; c < faces.cornerPositions.size(); ++c)
        if (faces.cornerPositions[c] != kNoPosition)
            groups.corners[groups.starts[first[faces.cornerPositions[c]] + 1]++] = c;
    groups.starts.pop_back();
    return groups;
}

const std::vector<glm::vec3>& SmoothNormals::make(const MeshFaces& faces, const CornerGroups& meetings,
                                                  const std::vector<glm::vec3>& rest,
                                                  const std::vector<glm::vec3>& deformed) {
    findShares(faces, rest, deformed, shares_);
    normals_.assign(faces.cornerPositions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
    for (std::size_t g = 0; g + 1 < meetings.starts.size(); ++g) {
        const std::uint32_t first = meetings.starts[g], count = meetings.starts[g + 1] - first;
        const std::span corners = std::span(meetings.corners).subspan(first, count);
        if (count <= kMostComparedFaces)
            smoothWithinCrease(corners, shares_, normals_);
        else
            smoothAll(corners, shares_, normals_);
    }
    return normals_;
}

std::vector<glm::vec3> smoothNormals(const MeshFaces& faces, const std::vector<glm::vec3>& rest,
                                     const std::vector<glm::vec3>& deformed) {
    return SmoothNormals().make(faces, groupCorners(faces, rest), rest, deformed);
}

}  // namespace walkcycle
