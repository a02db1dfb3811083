#pragma once

#include <climits>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "model/CpuSkinning.h"
#include "model/Influences.h"
#include "model/MeshData.h"

namespace walkcycle {

// Boxes around what each matrix of an instance's palette moves. Weights sum to one, so whatever the pose is, the mesh
// lies within the boxes as their matrices move them. Without influences there is one matrix. Empty where a
// position has none, or one below zero, which no box can hold.
std::vector<Bounds> boxesOfMatrices(const MeshData& mesh, const Influences* influences, std::size_t matrices);

// A rectangle of pixels, rows from the bottom, outside of which nothing was drawn.
class ScreenArea {
public:
    static ScreenArea whole() { return {}; }
    static ScreenArea none(int width, int height);

    // Makes room for a box that is moved into clip space; for the whole picture where it reaches behind the camera.
    void add(const Bounds& box, const glm::mat4& toClip);

    // First column and row, last column and row; with those around them, which are as clear as the rest.
    glm::ivec4 pixels() const;

private:
    int width_ = 0, height_ = 0;        // of the picture; 0: all of it, however large
    glm::vec2 min_{2.0f}, max_{-2.0f};  // the picture is from -1 to 1
};

}  // namespace walkcycle
