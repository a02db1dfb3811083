#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace walkcycle {

// Points of the plane, sorted into square cells, so that those near a place are found without looking at all.
class PointGrid {
public:
    void clear();
    void add(const glm::dvec2& point, std::uint32_t name);
    void build();  // after the last add()

    // Calls found(name) for the points in cells that the box touches, until it returns true; says whether it did.
    // `steps` is raised by the work done.
    template <typename Found>
    bool any(const glm::dvec2& low, const glm::dvec2& high, std::uint64_t& steps, Found found) const;

private:
    struct Point {
        glm::dvec2 at;
        std::uint32_t name;
    };
    std::size_t column(double x) const { return cell(x, low_.x, perUnit_.x); }
    std::size_t row(double y) const { return cell(y, low_.y, perUnit_.y); }
    std::size_t cell(double value, double low, double perUnit) const {
        const double c = (value - low) * perUnit;
        return c >= static_cast<double>(side_) ? side_ - 1 : c > 0.0 ? static_cast<std::size_t>(c) : 0;
    }

    std::vector<Point> points_;
    std::vector<std::uint32_t> names_;  // of the points, cell after cell
    std::vector<std::size_t> starts_;   // per cell: its first in names_; one more at the end
    std::size_t side_ = 1;              // cells per row and column
    glm::dvec2 low_{0.0}, perUnit_{0.0};
};

template <typename Found>
bool PointGrid::any(const glm::dvec2& low, const glm::dvec2& high, std::uint64_t& steps, Found found) const {
    for (std::size_t y = row(low.y); y <= row(high.y); ++y) {
        // The cells of a row lie side by side, so do their points.
        const std::size_t first = starts_[y * side_ + column(low.x)];
        const std::size_t end = starts_[y * side_ + column(high.x) + 1];
        steps += end - first + 1;
        for (std::size_t i = first; i < end; ++i)
            if (found(names_[i])) return true;
    }
    return false;
}

}  // namespace walkcycle
