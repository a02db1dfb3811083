#pragma once

#include <string>

#include "walkcycle/io/File.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {

// Whether writePicture can write a file of this name: .png, .webp, - (PNG to standard output) or a path below /dev/
// (PNG).
bool isPictureName(const std::string& path);

// Writes the picture in the format of its name, whole or not at all. Throws UsageError if !isPictureName(path), and
// FileError.
void writePicture(const std::string& path, const Image& image);

}  // namespace walkcycle
