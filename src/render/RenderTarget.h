#pragma once

#include <optional>

#include <epoxy/gl.h>

#include "render/Backdrop.h"

namespace walkcycle {

// Where a picture is drawn: a framebuffer's name (0: the window's own) and its size in pixels.
// A Framebuffer turns into one by itself; for a window write RenderTarget{0, size.width, size.height}.
struct RenderTarget {
    GLuint framebuffer = 0;
    int width = 1;
    int height = 1;
    // Where there is one, the renderer leaves the backdrop here, and whoever reads the picture lays it under what was
    // drawn; that is once a pixel, not once a sample. Where there is none, it is drawn first.
    std::optional<Backdrop>* underlay = nullptr;

    float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

}  // namespace walkcycle
