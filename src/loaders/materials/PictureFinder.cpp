#include "loaders/materials/PictureFinder.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "io/ImageDecoder.h"
#include "io/Uri.h"
#include "loaders/document/LimitCheck.h"
#include "loaders/document/LoadProgress.h"
#include "loaders/text/Spelling.h"

namespace walkcycle {
namespace fs = std::filesystem;
namespace {

constexpr std::array kUsualFolders = {"textures", "Textures", "texture", "Texture",
                                      "images",   "Images",   "image",   "Image",
                                      "maps",     "Maps",     "tex",     "materials/textures"};
constexpr std::array kPictureEndings = {".png", ".jpg", ".jpeg", ".tga", ".bmp", ".gif", ".psd", ".webp"};

// All pictures together exceed LoadLimits::maxTotalPixels, though each alone is within its limits.
struct PicturesTooLarge : std::runtime_error {
    explicit PicturesTooLarge(std::uint64_t pixels) : std::runtime_error("too many pixels"), amount(pixels) {}
    std::uint64_t amount;
};

bool isDrivePath(const std::string& path) {
    return path.size() > 1 && path[1] == ':';
}

std::string baseName(const std::string& path) {
    return fs::path(path).filename().string();
}

bool isPictureName(const std::string& name) {
    const std::string ending = fs::path(name).extension().string();
    return std::any_of(kPictureEndings.begin(), kPictureEndings.end(),
                       [&](const char* known) { return !inAnotherCase({known}, ending).empty(); });
}

// Recognises a picture by its first bytes, without decoding it. TGA has no signature, so its extension must
// do.
bool looksLikePicture(const Bytes& bytes, const std::string& path) {
    const auto startsWith = [&](const char* signature) {
        const std::size_t length = std::strlen(signature);
        return bytes.size() > length && std::memcmp(bytes.data(), signature, length) == 0;
    };
    for (const char* signature :
         {"\x89PNG\r\n\x1a\n", "\xff\xd8\xff", "GIF8", "BM", "8BPS", "RIFF", "P5", "P6"})
        if (startsWith(signature)) return true;
    return bytes.size() > 18 && !inAnotherCase({".tga"}, fs::path(path).extension().string()).empty();
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

Bytes bytesOfHex(std::string_view text) {
    Bytes bytes;
    int high = -1;
    for (const char c : text) {
        const int digit = hexDigit(c);
        if (digit < 0) continue;  // white space
        if (high < 0) {
            high = digit;
        } else {
            bytes.push_back(static_cast<std::uint8_t>(high * 16 + digit));
            high = -1;
        }
    }
    return bytes;
}

}  // namespace

const PictureFinder::Picture& PictureFinder::find(XmlNode where, const std::string& uri) {
    const auto [entry, isNew] = pictures_.try_emplace({where.file(), uri});
    if (!isNew) return entry->second;
    context_.checkCancelled(where);
    if (std::optional<File> file = search(where, uri)) entry->second = decode(where, uri, std::move(*file));
    context_.advance(LoadProgress::kPerPicture);
    return entry->second;
}

const PictureFinder::Picture& PictureFinder::embedded(XmlNode hex) {
    const std::string name = "embedded in line " + std::to_string(hex.line());
    const auto [entry, isNew] = pictures_.try_emplace({hex.file(), name});
    std::string joined;
    if (isNew) entry->second = decode(hex, name, {name, bytesOfHex(hex.rawText(joined))});
    return entry->second;
}

const PictureFinder::Picture& PictureFinder::chosenByUser() {
    const std::string& path = context_.options.texture;
    const auto [entry, isNew] = pictures_.try_emplace({std::string(), path});
    if (!isNew) return entry->second;
    try {
        if (std::optional<Bytes> bytes = context_.documents.readAsGiven(path))
            entry->second = decode({}, path, {path, std::move(*bytes)});
        else
            context_.diagnostics.report(Code::PictureMissing, path, 0, {path});
    } catch (const FileError& error) {
        context_.diagnostics.report(Code::PictureUnreadable, path, 0, {path, error.what()});
    }
    return entry->second;
}

std::optional<PictureFinder::File> PictureFinder::search(XmlNode where, const std::string& uri) {
    unreadable_ = false;
    if (std::optional<File> file = asWritten(where, uri)) return file;
    if (std::optional<File> file = guess(where, uri)) {
        context_.diagnostics.report(Code::PictureGuessed, where, {uri, file->path});
        return file;
    }
    if (unreadable_) return {};  // reported already
    const std::string scheme = parseUri(uri).scheme;
    const bool remote = !scheme.empty() && scheme != "file";
    context_.diagnostics.report(remote ? Code::PictureRemote : Code::PictureMissing, where, {uri});
    return {};
}

std::optional<PictureFinder::File> PictureFinder::asWritten(XmlNode where, const std::string& uri) {
    const Uri parts = parseUri(uri);
    if (!parts.scheme.empty() && parts.scheme != "file") return {};
    if (parts.path.empty() || !mayBeInside(where, parts.path)) return {};
    return read(where, parts.path);
}

// Tries the places where pictures are after files were moved. A file that has lost more than kMostGuesses
// pictures has lost them all; each guess looks into a dozen folders.
std::optional<PictureFinder::File> PictureFinder::guess(XmlNode where, const std::string& uri) {
    constexpr int kMostGuesses = 1000;
    const std::string path = parseUri(uri).path;
    const std::string name = baseName(path);
    if (name.empty() || ++guesses_ > kMostGuesses) return {};
    if (std::optional<File> file = read(where, name)) return file;
    // The name may contain a per cent sign that is no escape.
    if (std::optional<File> file = read(where, baseName(uri))) return file;
    const std::string folder = fs::path(path).parent_path().string();
    if (mayBeInside(where, path) && !folder.starts_with("..")) {
        if (std::optional<File> file = inFolder(where, folder, name)) return file;
    }
    if (std::optional<File> file = inFolder(where, "", name)) return file;
    for (const char* usual : kUsualFolders) {
        if (!context_.documents.mayHaveBeside(where, usual)) continue;
        if (std::optional<File> file = inFolder(where, usual, name)) return file;
    }
    if (std::optional<File> file = inAnotherFormat(where, name)) return file;
    return onlyPicture(where);
}

std::optional<PictureFinder::File> PictureFinder::inFolder(XmlNode where, const std::string& folder,
                                                           const std::string& name) {
    const std::string prefix = folder.empty() ? folder : folder + "/";
    if (std::optional<File> file = read(where, prefix + name)) return file;
    const std::string similar = inAnotherCase(context_.documents.listBeside(where, folder), name);
    return similar.empty() ? std::nullopt : read(where, prefix + similar);
}

// Finds a picture with the same name and another extension: "skin.dds" may have been made from "skin.png".
std::optional<PictureFinder::File> PictureFinder::inAnotherFormat(XmlNode where, const std::string& name) {
    const std::string stem = fs::path(name).stem().string();
    for (const std::string& other : context_.documents.listBeside(where, "")) {
        if (isPictureName(other) && !inAnotherCase({stem}, fs::path(other).stem().string()).empty())
            return read(where, other);
    }
    return {};
}

std::optional<PictureFinder::File> PictureFinder::onlyPicture(XmlNode where) {
    const std::vector<std::string> names = context_.documents.listBeside(where, "");
    if (std::count_if(names.begin(), names.end(), isPictureName) != 1) return {};
    return read(where, *std::find_if(names.begin(), names.end(), isPictureName));
}

// Reads a file beside the document. Path components that cancel out ("sub/../skin.png") need not exist.
std::optional<PictureFinder::File> PictureFinder::read(XmlNode where, const std::string& path) {
    try {
        std::string found;
        const std::string normal = fs::path(path).lexically_normal().string();
        const std::size_t most = context_.options.loadImages ? SIZE_MAX : 64;  // for looksLikePicture
        if (std::optional<Bytes> bytes = context_.documents.readBeside(where, normal, found, most))
            return File{std::move(found), std::move(*bytes)};
    } catch (const FileTooLarge& error) {
        reportUnreadable(where, path,
                         limitText(error.amount, context_.options.limits, &LoadLimits::maxFileBytes));
    } catch (const FileError& error) {
        reportUnreadable(where, path, error.what());
    } catch (const ArchiveError& error) {
        reportUnreadable(where, path, error.what());
    }
    return {};
}

// Once per search: a folder or a resolver that fails for one path fails for the guesses, too.
void PictureFinder::reportUnreadable(XmlNode where, const std::string& path, const std::string& reason) {
    if (!unreadable_) context_.diagnostics.report(Code::PictureUnreadable, where, {path, reason});
    unreadable_ = true;
}

// Whether a path may be read at all. An absolute path usually belongs to the disk of whoever exported the
// file; it is skipped without a report about folders.
bool PictureFinder::mayBeInside(XmlNode where, const std::string& path) const {
    if (isDrivePath(path)) return false;
    if (!fs::path(path).is_absolute() || !context_.options.allowedPaths.empty()) return true;
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(fs::absolute(where.file(), error).parent_path(), error);
    return !error && !fs::path(path).lexically_relative(folder).string().starts_with("..");
}

// Decodes a picture. Small files can hold large pictures, and a document can name many, so the total is
// limited.
std::shared_ptr<const Image> PictureFinder::decodeWithinLimits(const File& file) {
    const LoadLimits& limits = context_.options.limits;
    const auto decoded = context_.options.imagePixels ? decodeImage : measureImage;
    std::shared_ptr<const Image> image = ahead_ ? ahead_->take(file.path) : nullptr;
    if (!image) image = std::make_shared<const Image>(decoded(file.bytes, limits.image()));
    const auto pixels = static_cast<std::uint64_t>(std::int64_t{image->width} * image->height);
    if (pixels_ + pixels > limits.maxTotalPixels) throw PicturesTooLarge(pixels_ + pixels);
    pixels_ += pixels;
    return image;
}

PictureFinder::Picture PictureFinder::decode(XmlNode where, const std::string& name, File file) {
    const auto known = images_.find(file.path);
    if (known != images_.end()) return {file.path, known->second};
    std::shared_ptr<const Image>& image = images_[file.path];
    const auto tooLarge = [&](std::uint64_t amount, std::uint64_t LoadLimits::*limit) {
        const LimitWords words(amount, context_.options.limits, limit);
        report(Code::PictureOverLimit, where, file.path,
               {name, words.amount, words.unit, words.name, words.value});
    };
    try {
        if (context_.options.loadImages)
            image = decodeWithinLimits(file);
        else if (!looksLikePicture(file.bytes, file.path))
            throw ImageError("its first bytes are those of no known picture format");
    } catch (const PicturesTooLarge& error) {
        tooLarge(error.amount, &LoadLimits::maxTotalPixels);
    } catch (const ImageTooLarge& error) {
        tooLarge(error.amount, limitOf(error));
    } catch (const ImageError& error) {
        report(Code::PictureBroken, where, file.path, {name, error.what()});
    }
    return {file.path, image};
}

// Reports at the element that names the picture. The picture of LoadOptions::texture has none.
void PictureFinder::report(Code code, XmlNode where, const std::string& path,
                           Diagnostics::Arguments arguments) {
    if (where)
        context_.diagnostics.report(code, where, arguments);
    else
        context_.diagnostics.report(code, path, 0, arguments);
}

}  // namespace walkcycle
