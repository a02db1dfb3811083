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

// Per matrix of an instance's palette: the box around the positions that the matrix influences. The weights of a
// position sum to one, so in every pose the mesh lies within the convex hull of the boxes, each transformed by its
// matrix. If `influences` is null (no skin), there is one matrix. Returns no boxes if a position has no influence, a
// negative one or one of a matrix that does not exist, since then the boxes do not enclose it.
std::vector<Bounds> boxesOfMatrices(const MeshData& mesh, const Influences* influences, std::size_t matrices);

// A rectangle of pixels outside of which nothing was drawn; rows count from the bottom. It makes Framebuffer::read()
// faster: without it, a frame of `model.dae` on one colour (640x480, four samples) takes 11 % more processor time,
// and a frame with backdrop and grid 7 %.
class ScreenArea {
public:
    static ScreenArea whole() { return {}; }        // the whole picture, of any size
    static ScreenArea none(int width, int height);  // no pixel of a picture of this size

    // Extends the area by a box, which `toClip` transforms to clip space. If the box reaches behind the camera, the
    // area becomes the whole picture.
    void add(const Bounds& box, const glm::mat4& toClip);

    // The first column and row, and the last column and row, with a margin of some pixels.
    glm::ivec4 pixels() const;

private:
    int width_ = 0, height_ = 0;        // of the picture; 0: the area is the whole picture
    glm::vec2 min_{2.0f}, max_{-2.0f};  // the picture reaches from -1 to 1; min > max: nothing was added
};

}  // namespace walkcycle
