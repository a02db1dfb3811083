#pragma once

#include <vector>

#include "walkcycle/io/Image.h"

namespace walkcycle {

// The meaning of a picture's numbers.
enum class TexelKind {
    Color,  // sRGB colours: averaged as linear light, so that distant textures keep their brightness
    Data    // normals, heights: averaged as they are
};

// The picture at half its width and height, rounded down, but at least 1. Colours are weighted by alpha, so that
// transparent texels do not tint the others.
Image halved(const Image& image, TexelKind kind);

// All smaller levels of a picture, down to a single texel. (glGenerateMipmap of software OpenGL takes ten times as
// long.)
std::vector<Image> mipMaps(const Image& image, TexelKind kind);

}  // namespace walkcycle
