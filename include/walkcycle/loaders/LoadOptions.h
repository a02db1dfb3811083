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

// A contiguous range of bytes: std::vector<std::uint8_t>, std::vector<char>, std::vector<std::byte>, std::string,
// std::span<const std::uint8_t> ... Not a plain array: a string literal is one, and ends with a zero that is not part of
// its text.
template <typename T>
concept ByteRange = std::ranges::contiguous_range<const T> && std::ranges::sized_range<const T> &&
                        sizeof(std::ranges::range_value_t<const T>) == 1 &&
                    std::is_trivially_copyable_v<std::ranges::range_value_t<const T>> &&
                    !std::is_array_v<std::remove_cvref_t<T>>;

// The result of a FileResolver: the bytes of a file, or that there is no such file. A resolver may return any ByteRange, a
// std::optional of one, or std::nullopt. The bytes are copied, except those of a Bytes, which are moved.
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
    const Bytes& bytes() const { return *bytes_; }  // only if found()

private:
    std::optional<Bytes> bytes_;
};

// Reads a file that a document refers to: another document or a picture. `path` is the decoded path of the reference,
// resolved against the path or name of the document ("models/walker.dae" and "skin.png" make "models/skin.png"), with '/'
// between folders and without redundant "." and "..". One load asks for each path once, whatever the answer. If the
// resolver throws FileError, the file is reported as one that cannot be read; any other exception ends the load and
// reaches the caller of loadCollada.
using FileResolver = std::function<ResolvedFile(const std::string& path)>;

// The open document and its model, for the rules of <walkcycle/profiles/Profile.h>. Its members are private to the
// library.
struct Inspection;

// Whether the transform of an <instance_controller>'s node moves the skin in addition to its joints: the quirk
// skin-by-node. By COLLADA 1.4.1 (chapter 4, "Skin Deformation (or Skinning) in COLLADA") the joints alone place a skin.
enum class SkinNode {
    Auto,   // the document's exporter decides
    Apply,  // the node moves the skin
    Ignore  // the joints alone do
};

// How a document is read, and how much that may cost. The defaults are safe for a file from a stranger.
struct LoadOptions {
    // Convert to metres with Y up. The conversion is Skeleton::rootTransform: it applies to model transforms, while vertex
    // data stay as in the file. If false, everything is in the document's own unit and axes.
    bool convert = true;
    std::optional<UpAxis> upAxis;         // instead of the document's <up_axis>
    std::optional<double> metersPerUnit;  // instead of the document's <unit meter>; 1e-12 to 1e12
    SkinNode skinNode = SkinNode::Auto;
    // Switches quirks on (true) or off (false) by name, whatever exporter the document names. An entry "skin-by-node"
    // overrides skinNode. docs/collada-notes.md lists the names.
    std::map<std::string, bool> quirks;
    std::string scene;  // id or name of the <visual_scene> to show; empty: the one that <scene> names

    std::string texture;  // the path of a picture to use for every diffuse texture; empty: those of the file
    bool loadImages = true;   // false: textures have a path, but no image
    bool imagePixels = true;  // false: Image::rgba may be empty; only width, height and hasAlpha are known

    // Further folders whose files the document may refer to, besides its own folder and those below. A file elsewhere is
    // not opened (WC0208).
    std::vector<std::string> allowedPaths;
    // If set, it provides other documents and pictures (also `texture`), and no file on disk is opened except the one
    // whose path is given to loadCollada.
    FileResolver resolver;

    // Largest distance between the key frames of Model::animations and the file's own curves, as a share of the model's
    // size. Finite and greater than 0.
    double tolerance = 1e-4;
    LoadLimits limits;

    // Called with the share of the work that is done: some hundred rising values at most, the last of which is 1. Runs on
    // the thread that called loadCollada.
    std::function<void(double)> progress;
    // Called between pieces of work of some ten milliseconds (a large picture is one longer piece). If it returns true,
    // the load stops with a LoadError whose cancelled() is true, and no callback is called any more. Runs on the thread
    // that called loadCollada.
    std::function<bool()> cancelled;
    // Called once, when the model is complete and its document is still open.
    std::function<void(const Inspection&)> inspector;
};

// Whether an option or a document may give this length of a unit, in metres: from 1e-12 to 1e12.
constexpr bool isUsableUnit(double metersPerUnit) {
    return metersPerUnit >= 1e-12 && metersPerUnit <= 1e12;
}

// Thrown for a value of LoadOptions that is not allowed. what() names the option and the value:
// "LoadOptions::tolerance is 0; it must be a number over 0".
struct WALKCYCLE_API InvalidOption : std::invalid_argument {
    InvalidOption(const std::string& nameOfOption, const std::string& value, const std::string& whatItMustBe);

    std::string option;  // "tolerance", "metersPerUnit", "limits.nesting"
    std::string must;    // "must be a number over 0"
};

// Throws InvalidOption if a value of the options is not allowed. loadCollada calls it first.
WALKCYCLE_API void requireValid(const LoadOptions& options);

}  // namespace walkcycle
