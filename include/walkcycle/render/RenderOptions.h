#pragma once

#include <stdexcept>

#include <glm/vec3.hpp>
#include <walkcycle/Export.h>

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

struct PictureState;

// Where a picture is drawn: the name of an OpenGL framebuffer (0: the window's own) and its size in pixels.
// A Framebuffer converts to one; for a window write RenderTarget{0, size.width, size.height}.
struct RenderTarget {
    unsigned int framebuffer = 0;
    int width = 1;
    int height = 1;
    PictureState* picture = nullptr;  // set by Framebuffer, used by the renderers; null for any other target

    float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

// The graphics driver refuses what OpenGL 3.3 promises: a shader does not compile, or there is no room for a picture.
struct WALKCYCLE_API GraphicsError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace walkcycle
