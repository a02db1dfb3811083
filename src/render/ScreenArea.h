#pragma once

#include <climits>
#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "walkcycle/model/Bounds.h"
#include "walkcycle/model/Influences.h"
#include "walkcycle/model/MeshData.h"

namespace walkcycle {

// Per matrix of an instance's palette: the box of the positions that it influences. Weights sum to one, so in
// every pose the mesh lies within the boxes, each moved by its matrix. Without influences there is one
// matrix. Returns no boxes if a position has no influence or a negative one, since then the boxes do not
// enclose it.
std::vector<Bounds> boxesOfMatrices(const MeshData& mesh, const Influences* influences, std::size_t matrices);

// A rectangle of pixels, rows from the bottom, outside of which nothing was drawn.
// Framebuffer::read() is faster with it: without it, a plain frame of `model.dae` (640x480, four samples) takes 11 % more
// processor time, and one with backdrop and grid 7 %.
class ScreenArea {
public:
    static ScreenArea whole() { return {}; }
    static ScreenArea none(int width, int height);

    // Extends the area by a box that `toClip` moves to clip space; to the whole picture if the box reaches
    // behind the camera.
    void add(const Bounds& box, const glm::mat4& toClip);

    // First column and row, last column and row, with a margin around what was drawn.
    glm::ivec4 pixels() const;

private:
    int width_ = 0, height_ = 0;        // of the picture; 0: the area is the whole picture
    glm::vec2 min_{2.0f}, max_{-2.0f};  // the picture is from -1 to 1
};

}  // namespace walkcycle
