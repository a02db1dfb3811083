#include "render/Vao.h"

namespace walkcycle {
namespace {

GLuint newVertexArray() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
}

}  // namespace

Vao::Vao() : vertexArray_(newVertexArray()) {}

void Vao::floats(GLuint location, const Vbo& vbo, int components) {
    bind();
    vbo.bind();
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void Vao::unsignedInts(GLuint location, const Vbo& vbo, int components, GLenum type) {
    bind();
    vbo.bind();
    glEnableVertexAttribArray(location);
    glVertexAttribIPointer(location, components, type, 0, nullptr);
}

void Vao::indices(const Vbo& vbo) {
    bind();
    vbo.bind();
}

}  // namespace walkcycle
