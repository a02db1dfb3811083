#pragma once

#include <epoxy/gl.h>

namespace walkcycle {

// Where a picture is drawn: a framebuffer's name (0: the window's own) and its size in pixels.
// A Framebuffer turns into one by itself; for a window write RenderTarget{0, size.width, size.height}.
struct RenderTarget {
    GLuint framebuffer = 0;
    int width = 1;
    int height = 1;

    float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

}  // namespace walkcycle
