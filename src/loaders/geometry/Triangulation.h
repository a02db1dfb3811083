#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "loaders/geometry/PointGrid.h"

namespace walkcycle {

// Cuts polygons into triangles: convex polygons into a fan; others, and polygons with holes, by clipping ears
// (David Eberly, "Triangulation by Ear Clipping"). Use one object for many polygons: it keeps its memory.
class Triangulation {
public:
    // `points` are the corners of the outline, then those of each hole; ringEnds[i] is the index after the
    // last point of ring i. Returns three indices into `points` per triangle, wound like the outline, valid
    // until the next call. A polygon that crosses itself or has no area gets triangles that cover it as well
    // as possible.
    const std::vector<std::uint32_t>& cut(std::span<const glm::vec3> points,
                                          std::span<const std::uint32_t> ringEnds);

private:
    // A corner of the polygon that is left to cut. The corners are a linked ring. A hole is joined to the
    // outline by a bridge: two edges on the same line, one there and one back, so that the corners at both
    // ends exist twice.
    struct Corner {
        glm::dvec2 at;
        std::uint32_t point;  // index into `points`
        std::uint32_t previous, next;
        bool reflex;  // the angle inside is 180 degrees or more
    };
    void flatten(std::span<const glm::vec3> points, std::uint32_t outlineEnd);
    bool isConvex() const;
    void fan(std::uint32_t corner);

    std::uint32_t link(std::uint32_t begin, std::uint32_t end, bool asGiven);
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
    std::uint32_t remaining_ = 0;              // corners not yet clipped
    std::uint64_t steps_ = 0, mostSteps_ = 0;  // work done, and its limit
};

// The area vector of a polygon (Newell's method): its length is twice the area, and its direction is the
// normal, also if the polygon is not quite flat.
glm::dvec3 areaVector(std::span<const glm::vec3> ring);

}  // namespace walkcycle
