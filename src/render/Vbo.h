#pragma once

#include <cstddef>
#include <span>

#include "render/GlObject.h"

namespace walkcycle {

// A buffer on the GPU: vertices, indices, or the data of a BufferTexture.
class Vbo {
public:
    // `target` is the OpenGL target of store() and bind(): GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER or
    // GL_TEXTURE_BUFFER.
    explicit Vbo(GLenum target = GL_ARRAY_BUFFER);

    GLuint id() const { return buffer_.id(); }
    void bind() const { glBindBuffer(target_, buffer_.id()); }
    bool empty() const { return bytes_ == 0; }

    // Replaces the whole content. `usage` is GL_STREAM_DRAW for data that are written again for each picture.
    template <typename T>
    void store(std::span<const T> data, GLenum usage = GL_STATIC_DRAW) {
        storeBytes(data.data(), data.size_bytes(), usage);
    }

private:
    void storeBytes(const void* data, std::size_t bytes, GLenum usage);

    GlObject<gl::deleteBuffer> buffer_;
    GLenum target_;
    std::size_t bytes_ = 0;
};

}  // namespace walkcycle
