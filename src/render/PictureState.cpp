#include "render/PictureState.h"

#include <initializer_list>
#include <string>

#include "walkcycle/render/RenderOptions.h"

namespace walkcycle {
namespace {

using Renderbuffer = GlObject<gl::deleteRenderbuffer>;

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

void attach(GLenum attachment, GLuint renderbuffer) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

void requireComplete(int width, int height) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && glGetError() == GL_NO_ERROR)
        return;
    throw GraphicsError("the graphics driver has no room for a picture of " + std::to_string(width) + " by " +
                        std::to_string(height));
}

}  // namespace

Resolver::Resolver(int width, int height)
    : width_(width),
      height_(height),
      framebuffer_(newFramebuffer()),
      color_(newRenderbuffer(GL_SRGB8_ALPHA8, width, height, 0)) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    attach(GL_COLOR_ATTACHMENT0, color_.id());
    requireComplete(width, height);
}

const ShaderProgram& Resolver::program(int samples, const std::optional<Backdrop>& underlay) {
    std::optional<ShaderProgram>& found = programs_[underlay ? underlay->variant() : Backdrop::kVariants];
    if (found) return *found;
    const std::string defines = "#define SAMPLES " + std::to_string(samples) + "\n";
    if (underlay)
        found.emplace(ShaderProgram({{"backgroundVertex"}, {"backdrop", "resolveFragment"}},
                                    defines + underlay->defines() + "#define BACKDROP\n"));
    else
        found.emplace(ShaderProgram({{"backgroundVertex"}, {"resolveFragment"}}, defines));
    return *found;
}

void Resolver::resolve(const GlObject<gl::deleteTexture>& samplesTexture, int samples,
                       const std::optional<Backdrop>& underlay, const ScreenArea& drawn) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
    glEnable(GL_FRAMEBUFFER_SRGB);
    for (const GLenum state : std::initializer_list<GLenum>{GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE})
        glDisable(state);
    // This blending changes no pixel. Without it, software OpenGL compiles the shader twice: once more for blocks of
    // pixels that lie completely inside a triangle.
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samplesTexture.id());
    const ShaderProgram& chosen = program(samples, underlay);
    chosen.start();
    chosen.setSampler("samples", 0);
    setUniform(chosen.uniform("drawn"), drawn.pixels());
    if (underlay) underlay->load(chosen);
    noInputs_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

PictureState::PictureState(int pictureWidth, int pictureHeight, int pictureSamples)
    : width(pictureWidth),
      height(pictureHeight),
      samples(pictureSamples),
      framebuffer(newFramebuffer()),
      depth(newRenderbuffer(GL_DEPTH_COMPONENT24, width, height, samples > 1 ? samples : 0)) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    attach(GL_DEPTH_ATTACHMENT, depth.id());
    if (samples > 1) {
        samplesTexture = GlObject<gl::deleteTexture>(newMultisampleTexture(width, height, samples));
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE,
                               samplesTexture.id(), 0);
    } else {
        color = Renderbuffer(newRenderbuffer(GL_SRGB8_ALPHA8, width, height, 0));
        attach(GL_COLOR_ATTACHMENT0, color.id());
    }
    requireComplete(width, height);
    if (samples > 1) resolver = std::make_unique<Resolver>(width, height);
}

void PictureState::bindForReading() {
    if (resolver)
        resolver->resolve(samplesTexture, samples, backdrop, drawn);
    else
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.id());
}

}  // namespace walkcycle
