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

// Finds and decodes the pictures that <image>s name, each once. In order: the path as the file has it; its base name
// beside the document; both in another case; the usual subfolders; that name with another ending; the folder's only picture. All but the first is a
// guess and says so. Never the network, and nothing outside the document's folder tree unless it is allowed.
class PictureFinder {
public:
    // `ahead` may hold pictures that are decoded already; null: none are.
    explicit PictureFinder(const LoadContext& context, PicturesAhead* ahead = nullptr)
        : context_(context), ahead_(ahead) {}

    struct Picture {
        std::string path;                    // the file that was found; empty where none was
        std::shared_ptr<const Image> image;  // null where it is missing, broken, or images were not asked for
    };

    // `where` is the element that names the picture: its document is where the search starts.
    const Picture& find(XmlNode where, const std::string& uri);
    // The picture whose bytes stand in the document itself, as hexadecimal digits.
    const Picture& embedded(XmlNode hex);
    // The picture that the user gave for every diffuse texture.
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
    bool mayBeInside(XmlNode where, const std::string& path) const;
    Picture decode(XmlNode where, const std::string& name, File file);
    std::shared_ptr<const Image> decodeWithinLimits(const File& file);
    void report(Code code, XmlNode where, const std::string& path, Diagnostics::Arguments arguments);

    const LoadContext& context_;
    PicturesAhead* ahead_;
    std::map<std::pair<std::string, std::string>, Picture> pictures_;  // by document and URI
    std::map<std::string, std::shared_ptr<const Image>> images_;       // by path
    int guesses_ = 0;
    std::uint64_t pixels_ = 0;  // of all pictures together
};

}  // namespace walkcycle
