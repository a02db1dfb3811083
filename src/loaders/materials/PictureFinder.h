#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "loaders/context/LoadContext.h"
#include "loaders/materials/PicturesAhead.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// Finds and decodes the pictures of <image>s, each once. It tries the path as in the file; then its base name
// beside the document; both in another case; the usual subfolders; the base name with another extension; the
// only picture in the folder. All but the first are guesses, and are reported. It never uses the network, and
// opens nothing outside the folder tree of the document unless LoadOptions::allowedPaths has it.
class PictureFinder {
public:
    // `ahead` may have decoded some pictures already; null if there is none.
    explicit PictureFinder(const LoadContext& context, PicturesAhead* ahead = nullptr)
        : context_(context), ahead_(ahead) {}

    struct Picture {
        std::string path;  // the file that was found; empty if none was
        std::shared_ptr<const Image>
            image;  // null if it is missing, broken, or not asked for (LoadOptions::loadImages)
    };

    // `where` is the element that names the picture. Paths are relative to its document.
    const Picture& find(XmlNode where, const std::string& uri);
    // A picture whose bytes are in the document itself, as hexadecimal digits.
    const Picture& embedded(XmlNode hex);
    // The picture of LoadOptions::texture, which replaces every diffuse texture.
    const Picture& chosenByUser();

private:
    struct File {
        std::string path;
        Bytes bytes;
    };
    std::optional<File> search(XmlNode where, const std::string& uri);
    std::optional<File> asWritten(XmlNode where, const std::string& uri);
    std::optional<File> guess(XmlNode where, const std::string& uri);
    std::optional<File> inFolder(XmlNode where, const std::string& folder, const std::string& name);
    std::optional<File> inAnotherFormat(XmlNode where, const std::string& name);
    std::optional<File> onlyPicture(XmlNode where);
    std::optional<File> read(XmlNode where, const std::string& path);
    void reportUnreadable(XmlNode where, const std::string& path, const std::string& reason);
    bool mayBeInside(XmlNode where, const std::string& path) const;
    Picture decode(XmlNode where, const std::string& name, File file);
    std::shared_ptr<const Image> decodeWithinLimits(const File& file);
    void report(Code code, XmlNode where, const std::string& path, Diagnostics::Arguments arguments);

    const LoadContext& context_;
    PicturesAhead* ahead_;
    std::map<std::pair<std::string, std::string>, Picture> pictures_;  // by document and URI
    std::map<std::string, std::shared_ptr<const Image>> images_;       // by path
    bool unreadable_ = false;   // whether the present search has reported a file that cannot be read
    int guesses_ = 0;           // how many searches have needed guesses
    std::uint64_t pixels_ = 0;  // of all pictures together, for LoadLimits::maxTotalPixels
};

}  // namespace walkcycle
