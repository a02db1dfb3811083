#pragma once

#include <stdexcept>

#include <glm/vec3.hpp>
#include <walkcycle/Export.h>

namespace walkcycle {

// The lights and materials of a picture.
enum class Lighting {
    Studio,  // lamps around the camera: a key light, a fill light, a rim light, and soft light from the sky
    File     // the document's lights and materials, by the formulas of COLLADA 1.4.1, chapter 8
};

// The background of a picture.
enum class Background {
    Gradient,    // from grey at the top to a lighter grey at the bottom
    Color,       // RenderOptions::backgroundColor
    Transparent  // the picture's alpha is the coverage by the model times its opacity
};

// How a picture is drawn.
struct RenderOptions {
    Lighting lights = Lighting::Studio;
    Background background = Background::Gradient;
    glm::vec3 backgroundColor{0.5f};  // sRGB, as in #808080
    bool grid = true;                 // on the ground (y = 0); not drawn if the background is None
    bool wireframe = false;           // edges on top of the surface
    bool skeleton = false;            // joints on top of everything
};

struct PictureState;  // private: what a Framebuffer consists of

// The place to draw into: an OpenGL framebuffer and its size in pixels. A Framebuffer converts to a RenderTarget; for
// a window write RenderTarget{0, size.width, size.height} with its framebufferSize().
struct RenderTarget {
    unsigned int framebuffer = 0;  // its OpenGL name; 0 is the window's own
    int width = 1;
    int height = 1;
    PictureState* picture = nullptr;  // set by Framebuffer, used by the renderers; null for any other target

    float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

// No OpenGL context is current, the graphics driver refuses a call that OpenGL 3.3 allows (a shader does not compile, a
// picture finds no memory), or a CrowdRenderer cannot draw the model. The message names the reason.
struct WALKCYCLE_API GraphicsError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace walkcycle
