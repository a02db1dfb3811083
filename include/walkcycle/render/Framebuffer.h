#pragma once

#include <memory>

#include <walkcycle/Export.h>
#include <walkcycle/io/Image.h>
#include <walkcycle/render/RenderOptions.h>

namespace walkcycle {

// A multisampled picture to draw into. Colours are stored as sRGB; drawing and resolving use linear light. It belongs to
// the OpenGL context in which it was made.
//
//     Framebuffer picture(1280, 720);
//     renderer.render(model, camera, picture);
//     writeFile("walk.png", encodePng(picture.read()));
class WALKCYCLE_API Framebuffer {
public:
    // Has as many samples as asked for, or as the driver allows. Throws std::runtime_error if the driver
    // refuses the size.
    Framebuffer(int width, int height, int samples = 4);
    ~Framebuffer();
    Framebuffer(Framebuffer&&) noexcept;
    Framebuffer& operator=(Framebuffer&&) noexcept;

    int width() const;
    int height() const;
    int samples() const;
    float aspect() const;

    // If you draw with OpenGL calls of your own, ask for the target each time, after our renderers have drawn: read() may
    // skip pixels in which they left nothing, unless somebody has asked for the target since.
    RenderTarget target() const;
    operator RenderTarget() const { return target(); }  // NOLINT: a picture can be passed as a target

    // The picture, rows from the top, with straight alpha: coverage times opacity, and black where it is 0.
    Image read() const;

private:
    std::unique_ptr<PictureState> state_;
};

// The largest width or height that a Framebuffer can have here.
WALKCYCLE_API int maxFramebufferSize();

}  // namespace walkcycle
