#pragma once

#include <string>

#include "io/File.h"
#include "io/Image.h"

namespace walkcycle {

// Whether the name is one that writePicture can write: .png, .webp, or - (PNG to standard output).
bool isPictureName(const std::string& path);

// Writes the picture as its name says, whole or not at all.
void writePicture(const std::string& path, const Image& image);

}  // namespace walkcycle
