#pragma once

#include <algorithm>
#include <concepts>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <ranges>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/io/Bytes.h>
#include <walkcycle/loaders/LoadLimits.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// Anything whose elements are bytes that lie one after another: std::vector<std::uint8_t>, std::vector<char>,
// std::vector<std::byte>, std::string, std::span<const std::uint8_t> ... A plain array is not one: the array of a text in
// quotes has a zero at its end that is not of the text.
template <typename T>
concept ByteRange = std::ranges::contiguous_range<const T> && std::ranges::sized_range<const T> &&
                        sizeof(std::ranges::range_value_t<const T>) == 1 &&
                    std::is_trivially_copyable_v<std::ranges::range_value_t<const T>> &&
                    !std::is_array_v<std::remove_cvref_t<T>>;

// What a FileResolver gives: the bytes of a file, or that there is no such file. A resolver returns any ByteRange, an
// std::optional of one, or std::nullopt; the bytes are copied (those of a Bytes that is given away are not).
class WALKCYCLE_API ResolvedFile {
public:
    ResolvedFile(std::nullopt_t) {}
    ResolvedFile(Bytes bytes) : bytes_(std::move(bytes)) {}

    template <ByteRange T>
    requires(!std::same_as<T, Bytes>) ResolvedFile(const T& range)
        : bytes_(std::in_place, std::ranges::size(range)) {
        if (!bytes_->empty()) std::memcpy(bytes_->data(), std::ranges::data(range), bytes_->size());
    }

    template <typename T>
    requires(std::same_as<T, Bytes> || ByteRange<T>) ResolvedFile(std::optional<T> range) {
        if (range) *this = ResolvedFile(std::move(*range));
    }

    bool found() const { return bytes_.has_value(); }
    const Bytes& bytes() const { return *bytes_; }  // of a file that was found

private:
    std::optional<Bytes> bytes_;
};

// Reads another file that a document refers to. `path` is the path that the document gives, decoded, and resolved against
// the path or name of the document ("models/walker.dae" and "skin.png" make "models/skin.png"), with '/' between folders
// and without "." and ".." that can be left out. One load asks for each path once. A FileError that
// the resolver throws is reported like a file that cannot be read; all else that it throws ends the load and reaches the
// caller of loadCollada.
using FileResolver = std::function<ResolvedFile(const std::string& path)>;

// The document and the model while both are open, for the rules of other programs: see profiles/Profile.h. What is inside
// belongs to the library.
struct Inspection;

// Whether the node of an <instance_controller> moves its skin as well as the skin's joints do. COLLADA 1.4.1 (chapter 4,
// "Skin Deformation (or Skinning) in COLLADA") places a skin by its joints alone; ColladaMaya and Softimage mean both.
enum class SkinNode {
    Auto,   // as the exporter of the file means it
    Apply,  // the node moves the skin
    Ignore  // the joints alone do
};

// How a document is read, and what that may cost. The defaults fit a file from a stranger.
struct LoadOptions {
    // Convert to metres with Y up: in Skeleton::rootTransform, so that model transforms are converted and vertex data
    // stay as in the file. Without, everything is in the document's own unit and axes.
    bool convert = true;
    std::optional<UpAxis> upAxis;         // instead of the document's <up_axis>
    std::optional<double> metersPerUnit;  // instead of the document's <unit meter>; 1e-12 to 1e12
    SkinNode skinNode = SkinNode::Auto;
    // Quirks of exporters by name, on (true) or off, instead of what the document's tool says; they go before skinNode.
    // docs/collada-notes.md lists the names.
    std::map<std::string, bool> quirks;
    std::string scene;  // the <visual_scene> to show, by id or name; empty: the one that <scene> names

    std::string texture;  // the path of a picture to use for every diffuse texture; empty: those of the file
    bool loadImages = true;   // without, textures have a path and no image
    bool imagePixels = true;  // without, Image::rgba may be empty: only width, height and hasAlpha are known

    // Folders outside the document's own whose files the document may refer to. What is in none of them is not opened
    // (WC0208).
    std::vector<std::string> allowedPaths;
    // Where set, other documents and pictures (also `texture`) are asked of it, and no file is opened but the one whose
    // path is given to loadCollada.
    FileResolver resolver;

    // Largest distance between the key frames of Model::animations and the file's own curves, as a share of the model's
    // size. A number over 0.
    double tolerance = 1e-4;
    LoadLimits limits;

    // Called with the share of the work that is done: values that rise, the last of them 1; some hundred at most. On the
    // thread of the load.
    std::function<void(double)> progress;
    // Asked between pieces of work that take some ten milliseconds; true stops the load with a LoadError whose cancelled()
    // is true, and nothing more is called. On the thread of the load.
    std::function<bool()> cancelled;
    // Called once the model is made, while its document is still open.
    std::function<void(const Inspection&)> inspector;
};

// Whether a unit of so many metres can be used, of an option as of a document: from 1e-12 to 1e12.
constexpr bool isUsableUnit(double metersPerUnit) {
    return metersPerUnit >= 1e-12 && metersPerUnit <= 1e12;
}

// A value of LoadOptions that no load can use. what() names it: "LoadOptions::tolerance is 0; it must be a number over 0".
struct WALKCYCLE_API InvalidOption : std::invalid_argument {
    InvalidOption(const std::string& nameOfOption, const std::string& value, const std::string& whatItMustBe);

    std::string option;  // "tolerance", "metersPerUnit", "limits.nesting"
    std::string must;    // "must be a number over 0"
};

// Throws InvalidOption where a value cannot be used; loadCollada begins with it.
WALKCYCLE_API void requireValid(const LoadOptions& options);

}  // namespace walkcycle
