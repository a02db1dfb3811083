#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <glm/mat3x4.hpp>
#include <glm/vec3.hpp>

#include "render/ShaderProgram.h"

namespace walkcycle {

// The background of a picture: a gradient or one colour, and perhaps a grid on the ground, the plane y = 0. It has the
// numbers that shaders/backdrop.glsl needs.
struct Backdrop {
    struct Grid {
        // Maps a point of the picture, (x, y, 1) with x and y from -1 to 1, to the point of the ground that is
        // visible there. Of the result (a, b, c, d), a / c and b / c are x and z on the ground, in grid steps.
        // c is positive if that point lies in front of the camera, and d if it lies beyond the near plane: if
        // one of them is not positive, no ground is visible at this point of the picture.
        glm::mat3x4 groundAt{0.0f};
        // The grid's centre (x, z), and the radius at which it has faded out; in grid steps.
        glm::vec3 fading{0.0f, 0.0f, 1.0f};
    };

    bool encodesItself = false;      // the shader converts light to sRGB, because the target does not
    float pictureHeight = 1.0f;      // in pixels
    std::optional<glm::vec3> color;  // as stored in the target; if empty, the gradient is drawn
    std::optional<Grid> grid;

    // backdrop.glsl can be compiled in kVariants ways: with and without a grid, a colour, and the conversion to sRGB.
    // variant() is the number of the way that draws this backdrop, and defines() are its #defines.
    static constexpr std::size_t kVariants = 8;
    std::size_t variant() const;
    std::string defines() const;
    void load(const ShaderProgram& program) const;  // sets its uniforms; the program must be started
};

}  // namespace walkcycle
