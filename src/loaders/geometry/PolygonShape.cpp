#include "loaders/geometry/PolygonShape.h"

#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>

namespace walkcycle {
namespace {

// A polygon counts as a line if the square of its area is below this share of the square of the largest area
// that its extent allows: single precision cannot tell the two apart.
constexpr double kFlatSquared = 1e-14;

}  // namespace

PolygonShape shapeOf(std::span<const std::uint32_t> corners, std::span<const glm::vec3> positions) {
    const glm::dvec3 origin(positions[corners[0]]);
    glm::dvec3 edge = glm::dvec3(positions[corners[1]]) - origin;
    glm::dvec3 area(0.0), first(0.0), last(0.0);
    double size = glm::dot(edge, edge);  // squared extent of the polygon
    for (std::size_t i = 2; i < corners.size(); ++i) {
        const glm::dvec3 next = glm::dvec3(positions[corners[i]]) - origin;
        last = glm::cross(edge, next);
        if (i == 2) first = last;
        area += last;
        size = std::max(size, glm::dot(next, next));
        edge = next;
    }
    return {.hasArea = glm::dot(area, area) > kFlatSquared * size * size,
            .isPlain = glm::dot(first, area) > 0.0 && glm::dot(last, area) > 0.0};
}

}  // namespace walkcycle
