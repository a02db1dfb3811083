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

// Turns the samples of a picture into pixels, and lays the backdrop under them in the same pass. It has a shader of our
// own, because the one that software OpenGL makes for glBlitFramebuffer is compiled anew in each process, which takes
// 50 ms.
class Resolver {
public:
    Resolver(int width, int height);

    // Draws into a framebuffer of its own, from which the pixels can then be read.
    void resolve(const GlObject<gl::deleteTexture>& samplesTexture, int samples,
                 const std::optional<Backdrop>& underlay, const ScreenArea& drawn);

private:
    const ShaderProgram& program(int samples, const std::optional<Backdrop>& underlay);

    int width_, height_;
    GlObject<gl::deleteFramebuffer> framebuffer_;
    GlObject<gl::deleteRenderbuffer> color_;
    Vao noInputs_;
    // One per variant of the backdrop, and last the one without; each is made when first needed.
    std::array<std::optional<ShaderProgram>, Backdrop::kVariants + 1> programs_;
};

// What a Framebuffer is made of, and what the renderers leave in it so that reading it takes less time.
struct PictureState {
    // Throws GraphicsError if the driver has no room for the picture. `samples` is what the driver allows.
    PictureState(int width, int height, int samples);

    void bindForReading();  // with all samples resolved

    // Where the renderers leave the backdrop instead of drawing it: read() lays it under the picture, once per pixel
    // instead of once per sample. Null if there is only one sample per pixel; then the backdrop is drawn first.
    // Drawing it first takes 10 % more processor time for `render res/walker.dae` with a warm shader cache, 32 % for
    // `model.dae` with a cold one.
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
