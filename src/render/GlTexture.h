#pragma once

#include "model/Material.h"
#include "render/GlObject.h"
#include "render/MipMaps.h"

namespace walkcycle {

// A picture on the GPU, wrapped and filtered as the file's sampler says. (The series' Texture; that name is
// the model's here.) Shaders get linear light from a Color picture. Row 0 is the picture's top, so shaders
// look up 1 - v where COLLADA has v.
class GlTexture {
public:
    // The texture must have its image. A picture larger than the driver takes is halved until it fits.
    GlTexture(const Texture& texture, TexelKind kind);

    // A single white texel, for what has no picture.
    static GlTexture white();

    void bind(int unit) const;

private:
    GlTexture();

    GlObject<gl::deleteTexture> texture_;
};

}  // namespace walkcycle
