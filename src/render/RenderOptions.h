#pragma once

#include <glm/vec3.hpp>

namespace walkcycle {

enum class Lighting {
    Studio,  // our own: a key light, a fill light and soft light from the sky, for any model
    File     // the document's lights and materials, by the specification's formulas
};

enum class Background {
    Gradient,  // a soft neutral one
    Color,     // RenderOptions::backgroundColor
    None       // transparent: the picture's alpha is coverage times opacity
};

struct RenderOptions {
    Lighting lights = Lighting::Studio;
    Background background = Background::Gradient;
    glm::vec3 backgroundColor{0.5f};  // sRGB, as in #808080
    bool grid = true;                 // the ground, y = 0; never drawn on a transparent background
    bool wireframe = false;           // edges on top of the surface
    bool skeleton = false;            // joints on top of everything
};

}  // namespace walkcycle
