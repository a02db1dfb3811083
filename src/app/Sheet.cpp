#include "app/Sheet.h"

#include <algorithm>

#include "app/ExitCode.h"

namespace walkcycle {

Sheet::Sheet(std::pair<int, int> size, std::pair<int, int> columnsAndRows)
    : columns_(static_cast<std::size_t>(columnsAndRows.first)),
      rows_(static_cast<std::size_t>(columnsAndRows.second)),
      cellWidth_(size.first / columnsAndRows.first),
      cellHeight_(size.second / columnsAndRows.second) {
    if (cellWidth_ == 0 || cellHeight_ == 0)
        throw UsageError("--sheet: there are more cells than pixels in a row or column of the picture");
    image_.width = size.first;
    image_.height = size.second;
    image_.rgba.resize(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height) * 4,
                       0);
}

void Sheet::place(std::size_t cell, const Image& picture) {
    const std::size_t width = static_cast<std::size_t>(cellWidth_),
                      height = static_cast<std::size_t>(cellHeight_);
    const std::size_t left = cell % columns_ * width, top = cell / columns_ * height;
    for (std::size_t y = 0; y < height; ++y) {
        const auto from = picture.rgba.begin() + static_cast<std::ptrdiff_t>(y * width * 4);
        const std::size_t to = ((top + y) * static_cast<std::size_t>(image_.width) + left) * 4;
        std::copy(from, from + static_cast<std::ptrdiff_t>(width * 4),
                  image_.rgba.begin() + static_cast<std::ptrdiff_t>(to));
    }
    image_.hasAlpha = picture.hasAlpha;
}

}  // namespace walkcycle
