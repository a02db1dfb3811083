#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace walkcycle {

// Points of the plane in a grid of square cells. A search for the points in a box looks only at the cells
// that the box touches.
class PointGrid {
public:
    void clear();
    void add(const glm::dvec2& point, std::uint32_t name);  // `name`: what any() calls the point
    void build();                                           // after the last add()

    // Calls found(name) for the points of each cell that the box [low, high] touches, until a call returns
    // true. Returns whether one did. Adds the number of points and cells looked at to `steps`.
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
    std::vector<std::uint32_t> names_;  // of the points, sorted by cell
    std::vector<std::size_t> starts_;   // per cell: index of its first name; then the number of names
    std::size_t side_ = 1;              // cells per row and column
    glm::dvec2 low_{0.0}, perUnit_{0.0};
};

template <typename Found>
bool PointGrid::any(const glm::dvec2& low, const glm::dvec2& high, std::uint64_t& steps, Found found) const {
    for (std::size_t y = row(low.y); y <= row(high.y); ++y) {
        // The names of neighbouring cells of a row are neighbours in names_.
        const std::size_t first = starts_[y * side_ + column(low.x)];
        const std::size_t end = starts_[y * side_ + column(high.x) + 1];
        steps += end - first + 1;
        for (std::size_t i = first; i < end; ++i)
            if (found(names_[i])) return true;
    }
    return false;
}

}  // namespace walkcycle
