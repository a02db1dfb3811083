#pragma once

#include <cstddef>
#include <span>

#include "render/GlObject.h"
#include "render/Vbo.h"

namespace walkcycle {

// A long array that shaders read by index (texelFetch): palettes, influences, morph deltas, lights.
class BufferTexture {
public:
    // `format` is the format of an entry (texel): GL_RGBA32F, GL_RG32F or GL_RG32UI.
    explicit BufferTexture(GLenum format);

    void bind(int unit) const;

    template <typename T>
    void store(std::span<const T> data, GLenum usage = GL_STATIC_DRAW) {
        buffer_.store(data, usage);
    }

    // The most texels that a buffer texture can have on this device. OpenGL 3.3 guarantees 65,536.
    static std::size_t maxTexels();

private:
    Vbo buffer_;
    GlObject<gl::deleteTexture> texture_;
};

}  // namespace walkcycle
