#include "render/Framebuffer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

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

int maxSamples() {
    GLint samples = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    return samples;
}

void attach(GLenum attachment, GLuint renderbuffer) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

void requireComplete(int width, int height) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && glGetError() == GL_NO_ERROR)
        return;
    throw std::runtime_error("the graphics driver has no room for a picture of " + std::to_string(width) +
                             " by " + std::to_string(height));
}

// Drawn and blended colours are premultiplied with their alpha, in linear light; files want them straight.
void unpremultiply(std::vector<std::uint8_t>& rgba) {
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
void flipRows(std::vector<std::uint8_t>& rgba, std::size_t rowBytes) {
    const std::size_t rows = rgba.size() / rowBytes;
    for (std::size_t y = 0; y < rows / 2; ++y) {
        const auto top = rgba.begin() + static_cast<std::ptrdiff_t>(y * rowBytes);
        const auto bottom = rgba.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * rowBytes);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(rowBytes), bottom);
    }
}

}  // namespace

Framebuffer::Framebuffer(int width, int height, int samples) : drawn_(newFramebuffer()) {
    if (width < 1 || height < 1 || width > maxFramebufferSize() || height > maxFramebufferSize()) {
        throw std::runtime_error("a picture here is at least 1 and at most " +
                                 std::to_string(maxFramebufferSize()) + " pixels wide and high");
    }
    samples_ = std::clamp(samples, 0, maxSamples());
    target_ = {drawn_.id(), width, height};
    color_ = Renderbuffer(newRenderbuffer(GL_SRGB8_ALPHA8, width, height, samples_));
    depth_ = Renderbuffer(newRenderbuffer(GL_DEPTH_COMPONENT24, width, height, samples_));
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    attach(GL_COLOR_ATTACHMENT0, color_.id());
    attach(GL_DEPTH_ATTACHMENT, depth_.id());
    requireComplete(width, height);
    if (samples_ == 0) return;
    resolved_ = GlObject<gl::deleteFramebuffer>(newFramebuffer());
    resolvedColor_ = Renderbuffer(newRenderbuffer(GL_SRGB8_ALPHA8, width, height, 0));
    glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
    attach(GL_COLOR_ATTACHMENT0, resolvedColor_.id());
    requireComplete(width, height);
}

void Framebuffer::resolve() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
    if (samples_ == 0) return;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_FRAMEBUFFER_SRGB);  // samples are averaged as light, not as bytes
    glBlitFramebuffer(0, 0, width(), height(), 0, 0, width(), height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
}

Image Framebuffer::read() const {
    resolve();
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
