#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "loaders/geometry/PointGrid.h"

namespace walkcycle {

// Cuts polygons into triangles: convex ones into a fan, concave ones and those with holes by clipping ears. Keep one
// for many polygons, since it keeps its memory.
class Triangulation {
public:
    // `points` are the corners of the outline and, after them, of each hole; `ringEnds` says where each ends.
    // Gives three indices into `points` per triangle, wound like the outline. A polygon that no rule fits (it crosses
    // itself, or has no area) is covered as well as can be. Valid until the next call.
    const std::vector<std::uint32_t>& cut(std::span<const glm::vec3> points,
                                          std::span<const std::uint32_t> ringEnds);

private:
    // A corner of what is left to cut: one closed line, to which holes are joined by bridges (two corners each way).
    struct Corner {
        glm::dvec2 at;
        std::uint32_t point;  // index into `points`
        std::uint32_t previous, next;
        bool reflex;
    };
    void flatten(std::span<const glm::vec3> points, std::uint32_t outlineEnd);
    bool isConvex() const;
    void fan(std::uint32_t corner);

    std::uint32_t link(std::uint32_t begin, std::uint32_t end, bool counterClockwise);
    void joinHoles(std::span<const std::uint32_t> ringEnds);
    void bridge(std::uint32_t hole);
    std::uint32_t nearestRightOf(const glm::dvec2& point, double& hitX);
    std::uint32_t visibleFrom(const glm::dvec2& point);
    bool opensTo(const Corner& corner, const glm::dvec2& point) const;

    void clipEars();
    void clip(std::uint32_t corner);
    bool isEar(std::uint32_t corner);
    double orientationAt(std::uint32_t corner) const;

    std::vector<glm::dvec2> flat_;
    std::vector<Corner> corners_;
    PointGrid reflexCorners_;
    std::vector<std::uint32_t> triangles_;
    std::uint32_t remaining_ = 0;  // corners not yet clipped
    std::uint64_t steps_ = 0, mostSteps_ = 0;
};

// Twice the area of a closed line in space as a vector along its normal (Newell): its direction is the polygon's
// normal also where it is not quite flat.
glm::dvec3 areaVector(std::span<const glm::vec3> ring);

}  // namespace walkcycle
