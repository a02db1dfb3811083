#pragma once

#include <optional>

#include <epoxy/gl.h>

#include "render/Backdrop.h"

namespace walkcycle {

// Where a picture is drawn: the name of a framebuffer (0: the window's own) and its size in pixels.
// A Framebuffer converts to one; for a window write RenderTarget{0, size.width, size.height}.
struct RenderTarget {
    GLuint framebuffer = 0;
    int width = 1;
    int height = 1;
    // If not null, the renderer stores the backdrop here instead of drawing it, and the code that reads the
    // picture lays it under what was drawn: once per pixel instead of once per sample. If null, the backdrop
    // is drawn first.
    std::optional<Backdrop>* underlay = nullptr;

    float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
};

}  // namespace walkcycle
