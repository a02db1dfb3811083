#pragma once

#include <string>

#include "walkcycle/io/File.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {

// Whether writePicture can write a file of this name: .png, .webp, or - (PNG to standard output).
bool isPictureName(const std::string& path);

// Writes the picture in the format of its name, whole or not at all.
void writePicture(const std::string& path, const Image& image);

}  // namespace walkcycle
