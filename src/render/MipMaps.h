#pragma once

#include <vector>

#include "walkcycle/io/Image.h"

namespace walkcycle {

enum class TexelKind {
    Color,  // sRGB: averaged as light, so that distant textures keep their brightness
    Data    // normals, heights: averaged as they are
};

// The picture at half its width and height. Colours are weighted by alpha, so that transparent
// texels do not tint the others.
Image halved(const Image& image, TexelKind kind);

// All smaller levels of a picture, down to a single texel. (Software OpenGL needs 100 ms where this needs
// 10.)
std::vector<Image> mipMaps(const Image& image, TexelKind kind);

}  // namespace walkcycle
