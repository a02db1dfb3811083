#include "render/BufferTexture.h"

#include <cstddef>

namespace walkcycle {
namespace {

GLuint newBufferTexture(GLuint buffer, GLenum format) {
    GLuint id = 0;
    glGenTextures(1, &id);
    glBindTexture(GL_TEXTURE_BUFFER, id);
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
    return id;
}

// OpenGL creates a buffer when its name is first bound, and glTexBuffer refuses a name without a buffer.
GLuint bound(const Vbo& vbo) {
    vbo.bind();
    return vbo.id();
}

}  // namespace

BufferTexture::BufferTexture(GLenum format)
    : buffer_(GL_TEXTURE_BUFFER), texture_(newBufferTexture(bound(buffer_), format)) {}

void BufferTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, texture_.id());
}

std::size_t BufferTexture::maxTexels() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    return texels > 0 ? static_cast<std::size_t>(texels) : 0;
}

}  // namespace walkcycle
