#pragma once

namespace walkcycle {

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

}  // namespace walkcycle
