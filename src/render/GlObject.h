#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace walkcycle {

// Owns one OpenGL name: moves, does not copy, and is deleted with its owner. There is no cleanUp() to
// remember.
template <void (*Delete)(GLuint)>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(GLuint id) : id_(id) {}
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~GlObject() {
        if (id_) Delete(id_);
    }
    GLuint id() const { return id_; }  // 0 if it owns nothing

private:
    GLuint id_ = 0;
};

// The delete functions for GlObject's template argument. OpenGL's own cannot be used: libepoxy defines them as pointers
// that are set at run time.
namespace gl {
inline void deleteBuffer(GLuint id) {
    glDeleteBuffers(1, &id);
}
inline void deleteVertexArray(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
inline void deleteTexture(GLuint id) {
    glDeleteTextures(1, &id);
}
inline void deleteRenderbuffer(GLuint id) {
    glDeleteRenderbuffers(1, &id);
}
inline void deleteFramebuffer(GLuint id) {
    glDeleteFramebuffers(1, &id);
}
inline void deleteShader(GLuint id) {
    glDeleteShader(id);
}
inline void deleteProgram(GLuint id) {
    glDeleteProgram(id);
}
}  // namespace gl

}  // namespace walkcycle
