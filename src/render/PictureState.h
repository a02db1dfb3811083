#pragma once

#include <array>
#include <memory>
#include <optional>

#include "render/Backdrop.h"
#include "render/GlObject.h"
#include "render/ScreenArea.h"
#include "render/ShaderProgram.h"
#include "render/Vao.h"

namespace walkcycle {

// Computes the pixels of a picture from their samples, and draws the backdrop behind them in the same pass. It has a
// shader of its own instead of glBlitFramebuffer, because software OpenGL makes a shader for that call and compiles it
// anew in each process, which takes 50 ms.
class Resolver {
public:
    Resolver(int width, int height);

    // Draws into a framebuffer of its own, and leaves it bound, so that the pixels can be read. `underlay` is the
    // backdrop, if there is one. Outside of `drawn` the picture is known to be empty.
    void resolve(const GlObject<gl::deleteTexture>& samplesTexture, int samples,
                 const std::optional<Backdrop>& underlay, const ScreenArea& drawn);

private:
    const ShaderProgram& program(int samples, const std::optional<Backdrop>& underlay);

    int width_, height_;
    GlObject<gl::deleteFramebuffer> framebuffer_;
    GlObject<gl::deleteRenderbuffer> color_;
    Vao noInputs_;
    // One per variant of the backdrop, and at the end one without a backdrop. Each is compiled when it is first needed.
    std::array<std::optional<ShaderProgram>, Backdrop::kVariants + 1> programs_;
};

// The OpenGL objects of a Framebuffer, and two notes of the renderers that make read() faster: `backdrop` and `drawn`.
struct PictureState {
    // Throws GraphicsError if the driver has no room for the picture. `samples` is what the driver allows.
    PictureState(int width, int height, int samples);

    // Resolves the samples, and binds the framebuffer that has the pixels.
    void bindForReading();

    // If there are several samples per pixel, the renderers store the backdrop here instead of drawing it, and read()
    // draws it behind the picture, once per pixel instead of once per sample. Null if there is one sample per pixel:
    // then the backdrop is drawn first. Always drawing it first would take 10 % more processor time for `render
    // res/walker.dae` with a warm shader cache, and 32 % for `model.dae` with a cold one.
    std::optional<Backdrop>* underlay() { return resolver ? &backdrop : nullptr; }

    int width, height, samples;
    GlObject<gl::deleteFramebuffer> framebuffer;
    GlObject<gl::deleteTexture> samplesTexture;  // the colours, if there are several samples per pixel
    GlObject<gl::deleteRenderbuffer> color, depth;
    std::unique_ptr<Resolver> resolver;  // null if there is a single sample per pixel
    std::optional<Backdrop> backdrop;
    ScreenArea drawn = ScreenArea::whole();  // outside of it, only the backdrop shows
};

}  // namespace walkcycle
