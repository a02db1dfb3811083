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

// A picture to draw into, multisampled. Colours are kept sRGB-encoded; what is drawn and resolved is linear
// light.
//
//     Framebuffer picture(1280, 720);
//     renderer.render(model, camera, picture);
//     writeFile("walk.png", encodePng(picture.read()));
class Framebuffer {
public:
    // Takes as many samples as asked for, or as many as there are. Throws
    // std::runtime_error where the driver refuses the size.
    Framebuffer(int width, int height, int samples = 4);

    int width() const { return target_.width; }
    int height() const { return target_.height; }
    int samples() const { return samples_; }
    float aspect() const { return target_.aspect(); }

    const RenderTarget& target() const { return target_; }
    operator RenderTarget() const { return target_; }  // NOLINT: a framebuffer is a place to draw into

    // The picture, rows from the top, with straight alpha: coverage times opacity, and black where it is 0.
    Image read() const { return read(ScreenArea::whole()); }
    // The same, where nothing but the background was drawn outside of an area: on software OpenGL it takes less time.
    Image read(const ScreenArea& drawn) const;

private:
    void resolve(const ScreenArea& drawn) const;

    using Renderbuffer = GlObject<gl::deleteRenderbuffer>;
    // What a multisampled picture is resolved with, the backdrop on the same way. Our own shader, because the one that
    // software OpenGL makes for glBlitFramebuffer is compiled anew in each process, for 50 ms.
    struct Resolver {
        Resolver(int width, int height);
        const ShaderProgram& program(int samples);  // for the underlay as it is

        GlObject<gl::deleteFramebuffer> framebuffer;
        Renderbuffer color;
        Vao noInputs;
        std::optional<Backdrop> underlay;
        // Of each variant, and last the one without an underlay; made when first needed.
        std::array<std::optional<ShaderProgram>, Backdrop::kVariants + 1> programs;
    };

    GlObject<gl::deleteFramebuffer> framebuffer_;
    GlObject<gl::deleteTexture> samplesTexture_;  // the colours, where there are several a pixel
    Renderbuffer color_, depth_;
    std::unique_ptr<Resolver> resolver_;  // null where there is a single sample
    RenderTarget target_;
    int samples_ = 0;
};

// The largest width or height that a Framebuffer can have here.
int maxFramebufferSize();

}  // namespace walkcycle
