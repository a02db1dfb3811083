#include "walkcycle/render/Framebuffer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <epoxy/gl.h>

#include "render/CurrentContext.h"
#include "render/PictureState.h"
#include "render/Srgb.h"

namespace walkcycle {
namespace {

int maxSamples() {
    GLint forColor = 0, forDepth = 0;
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &forColor);
    glGetIntegerv(GL_MAX_SAMPLES, &forDepth);
    return std::min(forColor, forDepth);
}

// The number of samples with which a picture takes at most 1 GiB: 4 bytes of colour and 4 of depth per sample.
int affordable(int samples, int width, int height) {
    constexpr std::int64_t mostBytes = std::int64_t{1} << 30, bytesPerSample = 8;
    while (samples > 1 && bytesPerSample * samples * width * height > mostBytes) samples /= 2;
    return samples;
}

// The drawn colours are multiplied by their alpha, in linear light. In an Image they are not (straight alpha).
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

Framebuffer::Framebuffer(int width, int height, int samples) {
    requireContext();
    if (width < 1 || height < 1 || width > maxFramebufferSize() || height > maxFramebufferSize()) {
        throw std::runtime_error("the width and the height of a picture are at least 1 and at most " +
                                 std::to_string(maxFramebufferSize()) + " pixels on this device");
    }
    while (glGetError() != GL_NO_ERROR) {
        // forget errors of earlier calls; PictureState checks its own calls
    }
    const int allowed = std::clamp(samples, 1, std::max(maxSamples(), 1));
    state_ = std::make_unique<PictureState>(width, height, affordable(allowed, width, height));
}

Framebuffer::~Framebuffer() = default;
Framebuffer::Framebuffer(Framebuffer&&) noexcept = default;
Framebuffer& Framebuffer::operator=(Framebuffer&&) noexcept = default;

int Framebuffer::width() const {
    return state_->width;
}

int Framebuffer::height() const {
    return state_->height;
}

int Framebuffer::samples() const {
    return state_->samples;
}

float Framebuffer::aspect() const {
    return static_cast<float>(width()) / static_cast<float>(height());
}

RenderTarget Framebuffer::target() const {
    state_->drawn = ScreenArea::whole();  // the caller may draw anywhere
    return {state_->framebuffer.id(), state_->width, state_->height, state_.get()};
}

Image Framebuffer::read() const {
    state_->bindForReading();
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
