#pragma once

#include <optional>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/ShaderProgram.h"

namespace walkcycle {

// What a picture shows where no model covers it: a soft gradient, or one colour, and on the ground, the plane y = 0, a
// grid. Colours are light, or sRGB where the target does not turn light into it.
struct Backdrop {
    struct Grid {
        glm::mat4 fromPicture{1.0f};  // the inverse of the camera's viewProjection
        glm::vec3 center{0.0f};
        float radius = 1.0f;  // where it has faded out
        float spacing = 1.0f;
        glm::vec4 lineColor{0.0f};  // alpha: how strong the strongest line is
    };

    glm::vec3 top{0.0f}, bottom{0.0f};
    std::optional<Grid> grid;

    std::string defines() const { return grid ? "#define GRID\n" : ""; }  // for backdrop.glsl
    void load(const ShaderProgram& program) const;                        // which must be started
};

}  // namespace walkcycle
