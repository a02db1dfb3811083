#include "loaders/geometry/PointGrid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>

namespace walkcycle {

void PointGrid::clear() {
    points_.clear();
}

void PointGrid::add(const glm::dvec2& point, std::uint32_t name) {
    points_.push_back({point, name});
}

void PointGrid::build() {
    // About one point per cell. A grid of few points has one cell.
    side_ =
        points_.size() < 32 ? 1 : static_cast<std::size_t>(std::sqrt(static_cast<double>(points_.size())));
    low_ = points_.empty() ? glm::dvec2(0.0) : points_.front().at;
    glm::dvec2 high = low_;
    for (const Point& point : points_) {
        low_ = glm::min(low_, point.at);
        high = glm::max(high, point.at);
    }
    for (int axis = 0; axis < 2; ++axis)
        perUnit_[axis] =
            high[axis] > low_[axis] ? static_cast<double>(side_) / (high[axis] - low_[axis]) : 0.0;

    starts_.assign(side_ * side_ + 2, 0);
    const auto cellOf = [&](const Point& point) { return row(point.at.y) * side_ + column(point.at.x); };
    for (const Point& point : points_) ++starts_[cellOf(point) + 2];
    for (std::size_t i = 2; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    names_.resize(points_.size());
    for (const Point& point : points_) names_[starts_[cellOf(point) + 1]++] = point.name;
}

}  // namespace walkcycle
