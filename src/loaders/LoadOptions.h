#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/File.h"
#include "loaders/LoadLimits.h"
#include "model/Model.h"

namespace walkcycle {

struct Inspection;

// Whether an instance_controller's node moves its skin: the quirk skin-by-node, as the document's tool decides, on or off.
enum class SkinNode { Auto, Apply, Ignore };

// Reads another file that a document refers to: given the path as resolved against the document's own, gives its
// bytes, or nothing where there is none. For documents in memory.
using FileResolver = std::function<std::optional<Bytes>(const std::string& path)>;

struct LoadOptions {
    bool convert = true;                  // to Y-up metres, once, at the root
    std::optional<UpAxis> upAxis;         // instead of the document's own
    std::optional<double> metersPerUnit;  // instead of the document's own
    SkinNode skinNode = SkinNode::Auto;
    // Quirks of exporters by name, on (true) or off, instead of what the document's tool says. Goes before skinNode.
    // docs/collada-notes.md lists them; std::invalid_argument where one is not there.
    std::map<std::string, bool> quirks;
    std::string scene;    // the visual_scene to show, by id or name; empty: the one that <scene> names
    std::string texture;  // a picture to use for every diffuse texture
    std::vector<std::string> allowedPaths;  // folders outside the document's own that may be read
    bool loadImages = true;
    bool imagePixels = true;  // without them, Image::rgba may be empty: only the size is known
    double tolerance =
        1e-4;  // largest error of the keyframes against the file's curves, as a share of the model's size
    LoadLimits limits;
    std::function<void(double)> progress;  // called with 0..1 now and then
    std::function<bool()> cancelled;       // asked now and then; true stops the load with LoadError WC0802
    FileResolver resolver;                 // where set, no file is opened at all
    std::function<void(const Inspection&)> inspector;  // called once the model is made; see Inspection.h
};

}  // namespace walkcycle
