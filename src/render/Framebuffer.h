#pragma once

#include <array>
#include <memory>
#include <optional>

#include "io/Image.h"
#include "render/GlObject.h"
#include "render/RenderTarget.h"
#include "render/ScreenArea.h"
#include "render/ShaderProgram.h"
#include "render/Vao.h"

namespace walkcycle {

// A multisampled picture to draw into. Colours are stored as sRGB; drawing and resolving use linear light.
//
//     Framebuffer picture(1280, 720);
//     renderer.render(model, camera, picture);
//     writeFile("walk.png", encodePng(picture.read()));
class Framebuffer {
public:
    // Has as many samples as asked for, or as the driver allows. Throws std::runtime_error if the driver
    // refuses the size.
    Framebuffer(int width, int height, int samples = 4);

    int width() const { return target_.width; }
    int height() const { return target_.height; }
    int samples() const { return samples_; }
    float aspect() const { return target_.aspect(); }

    const RenderTarget& target() const { return target_; }
    operator RenderTarget() const { return target_; }  // NOLINT: a picture can be passed as a target

    // The picture, rows from the top, with straight alpha: coverage times opacity, and black where it is 0.
    Image read() const { return read(ScreenArea::whole()); }
    // The same, if nothing but the background was drawn outside of an area: software OpenGL takes less time
    // for it.
    Image read(const ScreenArea& drawn) const;

private:
    void resolve(const ScreenArea& drawn) const;

    using Renderbuffer = GlObject<gl::deleteRenderbuffer>;
    // Resolves a multisampled picture, and lays the backdrop under it in the same pass. It has a shader of
    // our own, because the one that software OpenGL makes for glBlitFramebuffer is compiled anew in each
    // process, which takes 50 ms.
    struct Resolver {
        Resolver(int width, int height);
        const ShaderProgram& program(int samples);  // for the present underlay

        GlObject<gl::deleteFramebuffer> framebuffer;
        Renderbuffer color;
        Vao noInputs;
        std::optional<Backdrop> underlay;
        // One per variant of the backdrop, and last the one without; each is made when first needed.
        std::array<std::optional<ShaderProgram>, Backdrop::kVariants + 1> programs;
    };

    GlObject<gl::deleteFramebuffer> framebuffer_;
    GlObject<gl::deleteTexture> samplesTexture_;  // the colours, if there are several samples per pixel
    Renderbuffer color_, depth_;
    std::unique_ptr<Resolver> resolver_;  // null if there is a single sample per pixel
    RenderTarget target_;
    int samples_ = 0;
};

// The largest width or height that a Framebuffer can have here.
int maxFramebufferSize();

}  // namespace walkcycle
