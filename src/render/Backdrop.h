#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <glm/mat3x4.hpp>
#include <glm/vec3.hpp>

#include "render/ShaderProgram.h"

namespace walkcycle {

// What a picture shows where no model covers it: a soft gradient, or one colour, and on the ground, the plane y = 0, a
// grid.
struct Backdrop {
    struct Grid {
        // Times a place in the picture (x, y, 1), both from -1 to 1: where on the ground it shows, in steps of the grid
        // (x, z) and homogeneous; the third number is over 0 where that is before the camera, the fourth where it is
        // beyond the nearest that it sees.
        glm::mat3x4 groundAt{0.0f};
        glm::vec3 fading{0.0f, 0.0f, 1.0f};  // around which place (x, z), and where it has gone; in steps
    };

    bool encodesItself = false;      // the target takes sRGB, and does not turn light into it
    float pictureHeight = 1.0f;      // in pixels
    std::optional<glm::vec3> color;  // as the target takes it; none: the gradient
    std::optional<Grid> grid;

    // Which of the programs of backdrop.glsl draws it: a number below kVariants, and what makes that one.
    static constexpr std::size_t kVariants = 8;
    std::size_t variant() const;
    std::string defines() const;
    void load(const ShaderProgram& program) const;  // which must be started
};

}  // namespace walkcycle
