#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <glm/mat3x4.hpp>
#include <glm/vec3.hpp>

#include "render/ShaderProgram.h"

namespace walkcycle {

// The background of a picture: a soft gradient or one colour, and perhaps a grid on the ground,
// the plane y = 0.
struct Backdrop {
    struct Grid {
        // Maps a point of the picture, (x, y, 1) with x and y from -1 to 1, to the ground that is visible
        // there. The first three numbers of the result are the ground's x and z in grid steps, in homogeneous
        // form: divide them by the third. The third is positive where the ground lies in front of the camera,
        // the fourth where it lies beyond the near plane; only where both are positive is the ground visible.
        glm::mat3x4 groundAt{0.0f};
        // The grid's centre (x, z), and the radius at which it has faded out; in grid steps.
        glm::vec3 fading{0.0f, 0.0f, 1.0f};
    };

    bool encodesItself = false;      // the shader converts light to sRGB, because the target does not
    float pictureHeight = 1.0f;      // in pixels
    std::optional<glm::vec3> color;  // as stored in the target; without one: the gradient
    std::optional<Grid> grid;

    // backdrop.glsl is compiled in kVariants ways. The number of the one that draws this backdrop, and its
    // #defines.
    static constexpr std::size_t kVariants = 8;
    std::size_t variant() const;
    std::string defines() const;
    void load(const ShaderProgram& program) const;  // the program must be started
};

}  // namespace walkcycle
