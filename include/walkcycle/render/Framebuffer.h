#pragma once

#include <memory>

#include <walkcycle/Export.h>
#include <walkcycle/io/Image.h>
#include <walkcycle/render/RenderOptions.h>

namespace walkcycle {

// A picture to draw into, with several samples per pixel for smooth edges. Colours are stored as sRGB; blending and the
// mean of the samples are computed in linear light. It belongs to the OpenGL context in which it was made.
//
//     Framebuffer picture(1280, 720);
//     renderer.render(model, camera, picture);
//     writeFile("walk.png", encodePng(picture.read()));
class WALKCYCLE_API Framebuffer {
public:
    // Width and height are in pixels, from 1 to maxFramebufferSize(). `samples` is per pixel; there are fewer if the
    // driver allows fewer, or if the picture would need more than 1 GiB. Throws std::runtime_error for other sizes,
    // and GraphicsError if the driver has no room for the picture.
    Framebuffer(int width, int height, int samples = 4);
    ~Framebuffer();
    Framebuffer(Framebuffer&&) noexcept;
    Framebuffer& operator=(Framebuffer&&) noexcept;

    int width() const;     // in pixels
    int height() const;    // in pixels
    int samples() const;   // per pixel, as allocated
    float aspect() const;  // width / height

    // The target for a renderer. If you draw with OpenGL calls of your own, call target() anew after each draw of our
    // renderers: they note the area that they have covered, and read() takes the pixels outside of it for background.
    // A call of target() makes the noted area the whole picture.
    RenderTarget target() const;
    operator RenderTarget() const { return target(); }  // NOLINT: a picture can be passed as a target

    // Copies the picture from the GPU: sRGB, rows from the top. Alpha is coverage times opacity, and the colours are
    // not multiplied by it (straight alpha); a pixel of alpha 0 is black.
    Image read() const;

private:
    std::unique_ptr<PictureState> state_;
};

// The largest width or height, in pixels, that a Framebuffer can have in the current OpenGL context.
WALKCYCLE_API int maxFramebufferSize();

}  // namespace walkcycle
