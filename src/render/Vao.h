#pragma once

#include "render/GlObject.h"
#include "render/Vbo.h"

namespace walkcycle {

// Says which buffer feeds which input of the vertex shader. It does not own the buffers, which must outlive it.
class Vao {
public:
    Vao();

    void bind() const { glBindVertexArray(vertexArray_.id()); }

    // Connects a buffer with the input at `location`. The buffer holds `components` numbers per vertex, without gaps.
    void floats(GLuint location, const Vbo& vbo, int components);
    void unsignedInts(GLuint location, const Vbo& vbo, int components, GLenum type = GL_UNSIGNED_INT);
    void indices(const Vbo& vbo);

private:
    GlObject<gl::deleteVertexArray> vertexArray_;
};

}  // namespace walkcycle
