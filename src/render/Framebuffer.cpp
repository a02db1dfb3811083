#include "render/Framebuffer.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/GraphicsError.h"
#include "render/Srgb.h"

namespace walkcycle {
namespace {

GLuint newFramebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
}

GLuint newRenderbuffer(GLenum format, int width, int height, int samples) {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    glBindRenderbuffer(GL_RENDERBUFFER, id);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return id;
}

GLuint newMultisampleTexture(int width, int height, int samples) {
    GLuint id = 0;
    glGenTextures(1, &id);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, id);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, GL_SRGB8_ALPHA8, width, height, GL_TRUE);
    return id;
}

int maxSamples() {
    GLint forColor = 0, forDepth = 0;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &forColor);
    glGetIntegerv(GL_MAX_SAMPLES, &forDepth);
    return std::min(forColor, forDepth);
}

// Very large pictures get fewer samples, so that they do not use up all memory.
int affordable(int samples, int width, int height) {
    constexpr std::int64_t most = std::int64_t{1} << 30, bytesPerSample = 8;
    while (samples > 1 && bytesPerSample * samples * width * height > most) samples /= 2;
    return samples;
}

void attach(GLenum attachment, GLuint renderbuffer) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

void requireComplete(int width, int height) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && glGetError() == GL_NO_ERROR)
        return;
    throw GraphicsError("the graphics driver has no room for a picture of " + std::to_string(width) + " by " +
                        std::to_string(height));
}

// Drawn and blended colours are premultiplied with their alpha, in linear light; files want them straight.
void unpremultiply(Bytes& rgba) {
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const std::uint8_t alpha = rgba[i + 3];
        if (alpha == 255) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const float straight = alpha ? linearOfSrgb(rgba[i + c]) * 255.0f / alpha : 0.0f;
            rgba[i + c] = srgbOfLinear(straight);
        }
    }
}

// OpenGL's rows start at the bottom.
void flipRows(Bytes& rgba, std::size_t rowBytes) {
    const std::size_t rows = rgba.size() / rowBytes;
    for (std::size_t y = 0; y < rows / 2; ++y) {
        const auto top = rgba.begin() + static_cast<std::ptrdiff_t>(y * rowBytes);
        const auto bottom = rgba.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * rowBytes);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(rowBytes), bottom);
    }
}

}  // namespace

Framebuffer::Resolver::Resolver(int width, int height)
    : framebuffer(newFramebuffer()), color(newRenderbuffer(GL_SRGB8_ALPHA8, width, height, 0)) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    attach(GL_COLOR_ATTACHMENT0, color.id());
    requireComplete(width, height);
}

const ShaderProgram& Framebuffer::Resolver::program(int samples) {
    std::optional<ShaderProgram>& found = programs[underlay ? underlay->variant() : Backdrop::kVariants];
    if (found) return *found;
    const std::string defines = "#define SAMPLES " + std::to_string(samples) + "\n";
    if (underlay)
        found.emplace(ShaderProgram({{"backgroundVertex"}, {"backdrop", "resolveFragment"}},
                                    defines + underlay->defines() + "#define BACKDROP\n"));
    else
        found.emplace(ShaderProgram({{"backgroundVertex"}, {"resolveFragment"}}, defines));
    return *found;
}

Framebuffer::Framebuffer(int width, int height, int samples) : framebuffer_(newFramebuffer()) {
    if (width < 1 || height < 1 || width > maxFramebufferSize() || height > maxFramebufferSize()) {
        throw std::runtime_error("a picture here is at least 1 and at most " +
                                 std::to_string(maxFramebufferSize()) + " pixels wide and high");
    }
    while (glGetError() != GL_NO_ERROR) {
        // errors of earlier calls; requireComplete() looks for our own
    }
    samples_ = affordable(std::clamp(samples, 1, std::max(maxSamples(), 1)), width, height);
    target_ = {.framebuffer = framebuffer_.id(), .width = width, .height = height};
    depth_ = Renderbuffer(newRenderbuffer(GL_DEPTH_COMPONENT24, width, height, samples_ > 1 ? samples_ : 0));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    attach(GL_DEPTH_ATTACHMENT, depth_.id());
    if (samples_ > 1) {
        samplesTexture_ = GlObject<gl::deleteTexture>(newMultisampleTexture(width, height, samples_));
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE,
                               samplesTexture_.id(), 0);
    } else {
        color_ = Renderbuffer(newRenderbuffer(GL_SRGB8_ALPHA8, width, height, 0));
        attach(GL_COLOR_ATTACHMENT0, color_.id());
    }
    requireComplete(width, height);
    if (samples_ == 1) return;
    resolver_ = std::make_unique<Resolver>(width, height);
    target_.underlay = &resolver_->underlay;
}

void Framebuffer::resolve(const ScreenArea& drawn) const {
    if (!resolver_) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
        return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, resolver_->framebuffer.id());
    glViewport(0, 0, width(), height());
    glEnable(GL_FRAMEBUFFER_SRGB);
    for (const GLenum state : std::initializer_list<GLenum>{GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE})
        glDisable(state);
    // This blending changes no pixel, but makes software OpenGL compile the shader once. Without blending it
    // compiles a second version, for blocks of pixels that lie completely inside a triangle.
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samplesTexture_.id());
    const ShaderProgram& program = resolver_->program(samples_);
    program.start();
    program.setSampler("samples", 0);
    setUniform(program.uniform("drawn"), drawn.pixels());
    if (resolver_->underlay) resolver_->underlay->load(program);
    resolver_->noInputs.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Image Framebuffer::read(const ScreenArea& drawn) const {
    resolve(drawn);
    Image image;
    image.width = width();
    image.height = height();
    image.hasAlpha = true;
    const std::size_t rowBytes = static_cast<std::size_t>(width()) * 4;
    image.rgba.resize(rowBytes * static_cast<std::size_t>(height()));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    unpremultiply(image.rgba);
    flipRows(image.rgba, rowBytes);
    return image;
}

int maxFramebufferSize() {
    GLint renderbuffer = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
    GLint viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    return std::min({renderbuffer, viewport[0], viewport[1]});
}

}  // namespace walkcycle
