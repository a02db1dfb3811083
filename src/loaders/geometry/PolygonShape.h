#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

namespace walkcycle {

struct PolygonShape {
    bool hasArea = false;  // the polygon is not just a line or a point
    // The first and the last triangle of the polygon's fan face the same way as the whole polygon: then a quad may be
    // cut from its first corner to its third.
    bool isPlain = false;
};

// `corners` are the polygon's positions in order, three or more, as indices into `positions`.
PolygonShape shapeOf(std::span<const std::uint32_t> corners, std::span<const glm::vec3> positions);

}  // namespace walkcycle
