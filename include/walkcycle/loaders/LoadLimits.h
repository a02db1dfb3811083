#pragma once

#include <cstdint>
#include <string_view>

#include <walkcycle/io/Image.h>

namespace walkcycle {

// The most that a load may cost, since files come from strangers. Honest files of 150 MB stay below the defaults. A
// message about a limit names it. kLimits below says what each limit counts, and why. A limit of 0 allows none.
struct LoadLimits {
    std::uint64_t maxFileBytes = std::uint64_t{1} << 30;
    std::uint64_t maxElements = 20'000'000;
    std::uint64_t maxNesting = 98;
    std::uint64_t maxNumbers = 100'000'000;
    std::uint64_t maxPositions = 50'000'000;
    std::uint64_t maxVertices = 25'000'000;
    std::uint64_t maxPolygonCorners = 1'000'000;
    std::uint64_t maxInfluencesPerVertex = 1024;
    std::uint64_t maxSkinJoints = 5'000'000;
    std::uint64_t maxNodes = 5'000'000;
    std::uint64_t maxSceneDepth = 1000;
    std::uint64_t maxNodeText = std::uint64_t{1} << 28;
    std::uint64_t maxInstancedElements = 1'000'000;
    std::uint64_t maxInstances = 5'000'000;
    std::uint64_t maxKeyNumbers = 100'000'000;
    std::uint64_t maxKeyFrames = 20'000'000;
    std::uint64_t maxDocuments = 256;
    std::uint64_t maxImageDimension = ImageLimits{}.maxDimension;
    std::uint64_t maxImagePixels = ImageLimits{}.maxPixels;
    std::uint64_t maxTotalPixels = 4 * ImageLimits{}.maxPixels;
    std::uint64_t maxArchiveBytes = std::uint64_t{1} << 30;
    std::uint64_t maxArchiveEntries = 10'000;
    std::uint64_t maxArchiveRatio = 200;
    std::uint64_t maxMessages = 1000;

    // The limits of one picture.
    ImageLimits image() const { return {maxImageDimension, maxImagePixels}; }
};

// How messages and docs/limits.md describe a limit.
struct LimitInfo {
    std::string_view name;  // "influences"
    std::uint64_t LoadLimits::*value;
    std::string_view unit;            // "1025 <unit> are over the limit influences=1024"
    std::string_view why;             // for docs/limits.md
    std::uint64_t most = UINT64_MAX;  // the largest value that the limit can be set to
};

// All limits. docs/limits.md is generated from these rows.
inline constexpr LimitInfo kLimits[] = {
    {"file-bytes", &LoadLimits::maxFileBytes, "bytes of a file",
     "A file is read whole. Characters are under 150 MB; a larger file is rarely one."},
    {"elements", &LoadLimits::maxElements, "XML elements of a document",
     "An element of five bytes costs some 150 bytes of memory. They are counted before the document is "
     "parsed."},
    {"nesting", &LoadLimits::maxNesting, "levels of nested elements",
     "The XML parser recurses once per level, and is built to stop here.", 98},
    {"numbers", &LoadLimits::maxNumbers, "numbers of one list",
     "A number of two bytes of text takes eight in memory. They are counted before they are parsed."},
    {"positions", &LoadLimits::maxPositions, "positions that meshes, skins and morph targets hold",
     "Many meshes may share one long source, and many skins and morph targets one mesh: each has its own "
     "copy."},
    {"vertices", &LoadLimits::maxVertices, "vertices of all drawn meshes",
     "A mesh counts each time that it is drawn, since it costs as much in a picture or a pose."},
    {"polygon-corners", &LoadLimits::maxPolygonCorners, "corners of one polygon with its holes",
     "Cutting a concave polygon into triangles visits up to 200 corners per corner."},
    {"influences", &LoadLimits::maxInfluencesPerVertex, "influences of one vertex",
     "The shader and CPU skinning add up all of them. Honest rigs have up to a dozen."},
    {"skin-joints", &LoadLimits::maxSkinJoints, "joints of all instances of skins",
     "Each instance of a skin has its own palette, and a single reference makes an instance."},
    {"nodes", &LoadLimits::maxNodes, "nodes of the scene",
     "A node takes some 800 bytes of memory, and a matrix in every pose."},
    {"scene-depth", &LoadLimits::maxSceneDepth, "levels of nodes in the scene",
     "Nested elements end at 98 levels, but <instance_node> adds more. Each level is compared with all "
     "above it, to find loops."},
    {"node-text", &LoadLimits::maxNodeText, "bytes of the names and ids of the scene's nodes",
     "Each instance of a node has its own copy of them, and they may be of any length."},
    {"instanced-elements", &LoadLimits::maxInstancedElements, "elements repeated by <instance_node>",
     "Instances within instances multiply: forty small nodes can become a million million. A node counts "
     "with its children, once per instance."},
    {"instances", &LoadLimits::maxInstances, "drawn meshes, counted with their parts,",
     "Each instance of a mesh has its own material for every part."},
    {"key-numbers", &LoadLimits::maxKeyNumbers, "numbers in the keys of all samplers",
     "Many samplers may share one long source; each makes its own curve."},
    {"key-frames", &LoadLimits::maxKeyFrames, "key frames made from the curves",
     "One sampler may move many joints, and clips may repeat it: each time it makes new key frames."},
    {"documents", &LoadLimits::maxDocuments, "other documents",
     "A document may refer to others, which refer to others."},
    {"image-dimension", &LoadLimits::maxImageDimension, "pixels on a side of a picture",
     "Graphics devices take no more. It is checked before anything is unpacked.", 65536},
    {"image-pixels", &LoadLimits::maxImagePixels, "pixels of a picture",
     "A pixel takes four bytes, and a few bytes of a file can claim billions of them.",
     std::uint64_t{1} << 32},
    {"total-pixels", &LoadLimits::maxTotalPixels, "pixels of all pictures",
     "Each of many pictures may be within its own limits."},
    {"archive-bytes", &LoadLimits::maxArchiveBytes, "bytes unpacked from an archive",
     "A .zae, or a document packed by gzip, can hold far more than its size."},
    {"archive-entries", &LoadLimits::maxArchiveEntries, "entries of an archive",
     "All names are read when the archive is opened."},
    {"archive-ratio", &LoadLimits::maxArchiveRatio, "times its packed size",
     "Data of over a megabyte that pack better than this were made to be a bomb. Text of numbers packs "
     "to a tenth."},
    {"messages", &LoadLimits::maxMessages, "messages about different things",
     "After that many, messages of one code are counted together, whatever they are about. Nothing fails."},
};

// The row of the limit that has this name; null if there is none.
constexpr const LimitInfo* findLimit(std::string_view name) {
    for (const LimitInfo& limit : kLimits)
        if (limit.name == name) return &limit;
    return nullptr;
}

// The row of a member of LoadLimits: limitInfo(&LoadLimits::maxNodes).
constexpr const LimitInfo& limitInfo(std::uint64_t LoadLimits::*value) {
    const LimitInfo* found = kLimits;
    while (found->value != value) ++found;
    return *found;
}

}  // namespace walkcycle
