#include "render/Vbo.h"

#include <cstddef>

namespace walkcycle {
namespace {

GLuint newBuffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
}

}  // namespace

Vbo::Vbo(GLenum target) : buffer_(newBuffer()), target_(target) {}

void Vbo::storeBytes(const void* data, std::size_t bytes, GLenum usage) {
    bind();
    glBufferData(target_, static_cast<GLsizeiptr>(bytes), data, usage);
    bytes_ = bytes;
}

}  // namespace walkcycle
