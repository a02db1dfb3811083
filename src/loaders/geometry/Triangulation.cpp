#include "loaders/geometry/Triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace walkcycle {
namespace {

// The limit on the work for one polygon, in corners looked at: so many per corner, and so many more. Real
// polygons need fewer. What a polygon that exceeds it has left is cut into a fan.
constexpr std::uint64_t kStepsPerCorner = 200, kStepsToBegin = 20000;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Twice the signed area of the triangle a, b, c: positive if its corners are counterclockwise.
double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - b);
}

bool inTriangle(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return orientation(a, b, p) >= 0.0 && orientation(b, c, p) >= 0.0 && orientation(c, a, p) >= 0.0;
}

double areaOf(std::span<const glm::dvec2> ring) {
    double area = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        area += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    return area;
}

}  // namespace

glm::dvec3 areaVector(std::span<const glm::vec3> ring) {
    glm::dvec3 area(0.0);
    // Relative to a corner, so that a polygon far from the document's origin loses no precision.
    const glm::dvec3 origin(ring[0]);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        area += glm::cross(glm::dvec3(ring[i]) - origin, glm::dvec3(ring[i + 1]) - origin);
    return area;
}

const std::vector<std::uint32_t>& Triangulation::cut(std::span<const glm::vec3> points,
                                                     std::span<const std::uint32_t> ringEnds) {
    triangles_.clear();
    corners_.clear();
    steps_ = 0;
    mostSteps_ = kStepsPerCorner * points.size() + kStepsToBegin;
    flatten(points, ringEnds[0]);
    link(0, ringEnds[0], true);
    remaining_ = ringEnds[0];
    if (ringEnds.size() == 1 && isConvex()) {
        fan(0);
        return triangles_;
    }
    joinHoles(ringEnds);
    clipEars();
    return triangles_;
}

// Projects the points along the axis that the polygon faces most. The outline is counterclockwise afterwards.
void Triangulation::flatten(std::span<const glm::vec3> points, std::uint32_t outlineEnd) {
    const glm::dvec3 normal = areaVector(points.first(outlineEnd));
    const glm::dvec3 size = glm::abs(normal);
    int x = 0, y = 1;
    if (size.x >= size.y && size.x >= size.z)
        x = 1, y = 2;
    else if (size.y >= size.z)
        x = 2, y = 0;
    if (normal[3 - x - y] < 0.0) std::swap(x, y);
    flat_.clear();
    for (const glm::vec3& point : points)
        flat_.push_back({static_cast<double>(point[x]), static_cast<double>(point[y])});
}

// Whether every corner is convex, and the outline goes round only once (x changes its direction at most
// twice).
bool Triangulation::isConvex() const {
    int reversals = 0;
    bool rightward = false;
    for (std::uint32_t i = 0; i < remaining_; ++i) {
        if (orientationAt(i) <= 0.0) return false;
        const bool goesRight = corners_[corners_[i].next].at.x > corners_[i].at.x;
        if (i > 0 && goesRight != rightward) ++reversals;
        rightward = goesRight;
    }
    return reversals <= 2;
}

void Triangulation::fan(std::uint32_t corner) {
    std::uint32_t b = corners_[corner].next;
    for (; remaining_ >= 3; --remaining_) {
        const std::uint32_t c = corners_[b].next;
        triangles_.insert(triangles_.end(), {corners_[corner].point, corners_[b].point, corners_[c].point});
        b = c;
    }
}

// Makes a linked ring of points [begin, end), in reverse order unless `asGiven`. Returns the index of its
// first corner.
std::uint32_t Triangulation::link(std::uint32_t begin, std::uint32_t end, bool asGiven) {
    const std::uint32_t first = static_cast<std::uint32_t>(corners_.size());
    const std::uint32_t count = end - begin;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t point = asGiven ? begin + i : end - 1 - i;
        corners_.push_back(
            {flat_[point], point, first + (i + count - 1) % count, first + (i + 1) % count, false});
    }
    return first;
}

double Triangulation::orientationAt(std::uint32_t corner) const {
    const Corner& c = corners_[corner];
    return orientation(corners_[c.previous].at, c.at, corners_[c.next].at);
}

// The holes are joined to the outline from right to left. A bridge goes to the right, so it cannot cross a
// hole that is not joined yet.
void Triangulation::joinHoles(std::span<const std::uint32_t> ringEnds) {
    std::vector<std::uint32_t> holes;  // the rightmost corner of each hole
    for (std::size_t ring = 1; ring < ringEnds.size(); ++ring) {
        const std::uint32_t begin = ringEnds[ring - 1], end = ringEnds[ring];
        const bool clockwise = areaOf(std::span(flat_).subspan(begin, end - begin)) < 0.0;
        std::uint32_t rightmost = link(begin, end, clockwise);
        for (std::uint32_t i = rightmost; i < corners_.size(); ++i)
            if (corners_[i].at.x > corners_[rightmost].at.x) rightmost = i;
        holes.push_back(rightmost);
    }
    std::sort(holes.begin(), holes.end(), [&](std::uint32_t a, std::uint32_t b) {
        return corners_[a].at.x != corners_[b].at.x ? corners_[a].at.x > corners_[b].at.x : a < b;
    });
    for (const std::uint32_t hole : holes)
        if (steps_ < mostSteps_) bridge(hole);
}

// Joins a hole to the outline by a bridge from `hole`, its rightmost corner, to a corner of the outline that
// can be seen from there.
void Triangulation::bridge(std::uint32_t hole) {
    const std::uint32_t outer = visibleFrom(corners_[hole].at);
    if (outer == corners_.size()) return;  // the hole is outside the outline
    for (std::uint32_t i = corners_[hole].next; i != hole; i = corners_[i].next) ++remaining_;
    remaining_ += 3;

    const auto holeAgain = static_cast<std::uint32_t>(corners_.size());
    const std::uint32_t outerAgain = holeAgain + 1;
    corners_.push_back({corners_[hole].at, corners_[hole].point, corners_[hole].previous, outerAgain, false});
    corners_.push_back({corners_[outer].at, corners_[outer].point, holeAgain, corners_[outer].next, false});
    corners_[corners_[hole].previous].next = holeAgain;
    corners_[corners_[outer].next].previous = outerAgain;
    corners_[outer].next = hole;
    corners_[hole].previous = outer;
}

// Finds the first edge of the outline that a ray from the point to the right meets, and sets hitX. Returns
// its end that is further right, or corners_.size() if there is no such edge.
std::uint32_t Triangulation::nearestRightOf(const glm::dvec2& point, double& hitX) {
    auto nearest = static_cast<std::uint32_t>(corners_.size());
    hitX = std::numeric_limits<double>::infinity();
    std::uint32_t i = 0;
    do {
        const Corner& a = corners_[i];
        const Corner& b = corners_[a.next];
        ++steps_;
        // Upward edges: the inside of the outline is to their left.
        if (a.at.y <= point.y && b.at.y >= point.y && a.at.y < b.at.y) {
            const double x = a.at.x + (point.y - a.at.y) / (b.at.y - a.at.y) * (b.at.x - a.at.x);
            if (x >= point.x && x < hitX) {
                hitX = x;
                nearest = a.at.x > b.at.x ? i : a.next;
            }
        }
        i = a.next;
    } while (i != 0);
    return nearest;
}

// Finds a corner of the outline that a straight line within the polygon joins to the point (Eberly, section
// 3): the end of the edge that the ray hits or, if corners lie in the triangle between, the one of them that
// is nearest to the direction of the ray.
std::uint32_t Triangulation::visibleFrom(const glm::dvec2& point) {
    double hitX = 0.0;
    const std::uint32_t candidate = nearestRightOf(point, hitX);
    if (candidate == corners_.size()) return candidate;
    const glm::dvec2 hit(hitX, point.y), end = corners_[candidate].at;
    const bool below = end.y < point.y;
    std::uint32_t best = candidate;
    double bestSlope = std::numeric_limits<double>::infinity(), bestX = bestSlope;
    std::uint32_t i = 0;
    do {
        const Corner& corner = corners_[i];
        ++steps_;
        if (inTriangle(corner.at, point, below ? end : hit, below ? hit : end) && opensTo(corner, point)) {
            const double dx = corner.at.x - point.x;
            const double slope = dx > 0.0 ? std::abs(corner.at.y - point.y) / dx : 0.0;
            if (slope < bestSlope || (slope == bestSlope && corner.at.x < bestX)) {
                best = i;
                bestSlope = slope;
                bestX = corner.at.x;
            }
        }
        i = corner.next;
    } while (i != 0);
    return best;
}

// Whether the point lies between the two edges of the corner, inside the polygon. If bridges have made
// several corners at one place, this is true for one of them only.
bool Triangulation::opensTo(const Corner& corner, const glm::dvec2& point) const {
    const glm::dvec2 before = corners_[corner.previous].at, after = corners_[corner.next].at;
    const bool leftOfBefore = orientation(before, corner.at, point) >= 0.0;
    const bool leftOfAfter = orientation(corner.at, after, point) >= 0.0;
    return orientation(before, corner.at, after) >= 0.0 ? leftOfBefore && leftOfAfter
                                                        : leftOfBefore || leftOfAfter;
}

// An ear is a corner whose triangle holds no other corner; only reflex corners can be in the way.
bool Triangulation::isEar(std::uint32_t corner) {
    ++steps_;
    if (orientationAt(corner) <= 0.0) return false;
    const glm::dvec2 b = corners_[corner].at;
    const glm::dvec2 a = corners_[corners_[corner].previous].at, c = corners_[corners_[corner].next].at;
    const auto blocks = [&](std::uint32_t other) {
        const glm::dvec2& p = corners_[other].at;
        return corners_[other].reflex && p != a && p != b && p != c && inTriangle(p, a, b, c);
    };
    return !reflexCorners_.any(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), steps_, blocks);
}

void Triangulation::clip(std::uint32_t corner) {
    const std::uint32_t before = corners_[corner].previous, after = corners_[corner].next;
    triangles_.insert(triangles_.end(),
                      {corners_[before].point, corners_[corner].point, corners_[after].point});
    corners_[before].next = after;
    corners_[after].previous = before;
    corners_[corner].reflex = false;
    for (const std::uint32_t neighbour : {before, after})
        if (corners_[neighbour].reflex) corners_[neighbour].reflex = orientationAt(neighbour) <= 0.0;
    --remaining_;
}

void Triangulation::clipEars() {
    reflexCorners_.clear();
    std::uint32_t corner = 0;
    for (std::uint32_t i = 0; i < remaining_; ++i, corner = corners_[corner].next) {
        corners_[corner].reflex = orientationAt(corner) <= 0.0;
        if (corners_[corner].reflex) reflexCorners_.add(corners_[corner].at, corner);
    }
    reflexCorners_.build();

    std::uint32_t misses = 0;
    while (remaining_ > 3 && steps_ < mostSteps_) {
        const std::uint32_t next = corners_[corner].next;
        // If a whole round finds no ear, the polygon crosses itself or has no area left. Then any corner is
        // clipped.
        if (isEar(corner) || misses > remaining_) {
            clip(corner);
            misses = 0;
            corner = corners_[next].next;  // skipping a corner makes triangles that are less thin
        } else {
            ++misses;
            corner = next;
        }
    }
    fan(corner);
}

}  // namespace walkcycle
