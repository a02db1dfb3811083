#pragma once

#include "render/GlObject.h"
#include "render/Vbo.h"

namespace walkcycle {

// Which buffer feeds which of the vertex shader's inputs. It keeps no buffer alive: they belong to the model.
class Vao {
public:
    Vao();

    void bind() const { glBindVertexArray(vertexArray_.id()); }

    // Each vertex finds `components` numbers at its turn in the buffer, one after the other.
    void floats(GLuint location, const Vbo& vbo, int components);
    void unsignedInts(GLuint location, const Vbo& vbo, int components, GLenum type = GL_UNSIGNED_INT);
    void indices(const Vbo& vbo);

private:
    GlObject<gl::deleteVertexArray> vertexArray_;
};

}  // namespace walkcycle
