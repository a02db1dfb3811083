#pragma once

#include "render/GlObject.h"
#include "render/MipMaps.h"
#include "walkcycle/model/Material.h"

namespace walkcycle {

// A picture on the GPU, wrapped and filtered as the file's <sampler2D> says. (It is the series' Texture; here that name
// belongs to the model's data.) From a Color picture, shaders read linear light. Row 0 is the top of the picture, while
// v = 0 in COLLADA is the bottom, so shaders read at 1 - v.
class GlTexture {
public:
    // texture.image must not be null. If the picture is larger than the driver allows, it is halved until it fits.
    GlTexture(const Texture& texture, TexelKind kind);

    // A single white texel, for slots without a picture.
    static GlTexture white();

    void bind(int unit) const;

private:
    GlTexture();

    GlObject<gl::deleteTexture> texture_;
};

}  // namespace walkcycle
