#pragma once

#include <vector>

#include "io/Image.h"

namespace walkcycle {

enum class TexelKind {
    Color,  // sRGB: averaged as light, so that distant textures keep their brightness
    Data    // normals, heights: averaged as they are
};

// The picture at half its width and height. Transparent texels do not bleed their colour into the others.
Image halved(const Image& image, TexelKind kind);

// All smaller levels of a picture, down to a single texel. (Software OpenGL takes 100 ms for what takes 10
// here.)
std::vector<Image> mipMaps(const Image& image, TexelKind kind);

}  // namespace walkcycle
