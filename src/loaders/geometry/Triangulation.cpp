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

// A polygon may cost this many looks at its corners, per corner. Honest ones need fewer; for those made to be slow the
// rest is cut without looking.
constexpr std::uint64_t kStepsPerCorner = 200, kStepsToBegin = 20000;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

// Positive where a, b, c turn left.
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
    const glm::dvec3 origin(
        ring[0]);  // near the polygon, so that little is lost far from the document's origin
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

// Drops the axis that the polygon faces most; the outline then turns left (counterclockwise).
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

// Whether every corner turns left, and all of them together once around.
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

// Makes corners of points [begin, end), joined to a ring of the asked direction; gives the first one's index.
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

// Holes are joined from right to left, so that a bridge to the right never meets one that is still to come.
void Triangulation::joinHoles(std::span<const std::uint32_t> ringEnds) {
    std::vector<std::uint32_t> holes;  // the rightmost corner of each
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

// Cuts the outline open at a corner that the hole's rightmost corner sees, and leads it around the hole and back.
void Triangulation::bridge(std::uint32_t hole) {
    const std::uint32_t outer = visibleFrom(corners_[hole].at);
    if (outer == corners_.size()) return;  // not inside the outline at all
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

// The outline's edge that a ray to the right meets first; of its ends the one further right.
std::uint32_t Triangulation::nearestRightOf(const glm::dvec2& point, double& hitX) {
    auto nearest = static_cast<std::uint32_t>(corners_.size());
    hitX = std::numeric_limits<double>::infinity();
    std::uint32_t i = 0;
    do {
        const Corner& a = corners_[i];
        const Corner& b = corners_[a.next];
        ++steps_;
        if (a.at.y <= point.y && b.at.y >= point.y &&
            a.at.y < b.at.y) {  // the inside is to the left of upward edges
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

// A corner of the outline that can be joined to the point by a straight line within the polygon (Eberly): the end of
// the edge to the right, unless corners stand between; of those the one nearest to the ray's direction.
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

// Whether the point lies between the two edges of the corner, on the polygon's side. Of corners at the same place,
// which bridges make, only one does.
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
        // Where a whole round finds no ear the polygon crosses itself, or has no area left: any corner will do.
        if (isEar(corner) || misses > remaining_) {
            clip(corner);
            misses = 0;
            corner = corners_[next].next;  // skipping one makes rounder triangles
        } else {
            ++misses;
            corner = next;
        }
    }
    fan(corner);
}

}  // namespace walkcycle
