#pragma once

#include <cstddef>
#include <utility>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// One picture made of several: a grid of equal cells, numbered row by row. If the size does not divide evenly, some
// columns at the right and rows at the bottom stay empty.
class Sheet {
public:
    // Throws UsageError if a cell would have no pixels.
    Sheet(std::pair<int, int> size, std::pair<int, int> columnsAndRows);

    int cellWidth() const { return cellWidth_; }
    int cellHeight() const { return cellHeight_; }
    std::size_t cellCount() const { return columns_ * rows_; }
    // Copies a picture of the size of a cell.
    void place(std::size_t cell, const Image& picture);
    const Image& image() const { return image_; }

private:
    Image image_;
    std::size_t columns_, rows_;
    int cellWidth_, cellHeight_;
};

}  // namespace walkcycle
