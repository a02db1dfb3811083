#include "app/PictureFile.h"

#include <algorithm>

#include "app/ExitCode.h"
#include "walkcycle/io/File.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

bool endsWith(std::string path, const std::string& extension) {
    std::transform(path.begin(), path.end(), path.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return path.ends_with(extension);
}

}  // namespace

bool isPictureName(const std::string& path) {
    return path == "-" || path.starts_with("/dev/") || endsWith(path, ".png") || endsWith(path, ".webp");
}

void writePicture(const std::string& path, const Image& image) {
    if (!isPictureName(path))
        throw UsageError("'" + path + "' is not a .png or .webp, which are the pictures that can be written");
    writeFile(path, endsWith(path, ".webp") ? encodeWebp(image) : encodePng(image));
}

}  // namespace walkcycle
