#pragma once

#include "render/GlObject.h"
#include "render/MipMaps.h"
#include "walkcycle/model/Material.h"

namespace walkcycle {

// A picture on the GPU, wrapped and filtered as the file's sampler says. (It is the series' Texture; here the
// model uses that name.) From a Color picture, shaders read linear light. Row 0 is the top of the picture, so
// a shader reads at 1 - v for COLLADA's v.
class GlTexture {
public:
    // The texture must have its image. A picture larger than the driver takes is halved until it fits.
    GlTexture(const Texture& texture, TexelKind kind);

    // A single white texel, for slots without a picture.
    static GlTexture white();

    void bind(int unit) const;

private:
    GlTexture();

    GlObject<gl::deleteTexture> texture_;
};

}  // namespace walkcycle
