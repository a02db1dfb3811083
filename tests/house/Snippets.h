#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace walkcycle::house {

// A fence of a page that quotes the source: ```cpp src/animation/Pose.cpp modelTransforms
// The definition may be a function ("modelTransforms", "JointTransform::interpolate"), a type ("struct
// Skin"), a constant ("kNoParent"), or "*" for the whole file.
struct Fence {
    std::string file;           // "walkcycle" for the program
    std::string definition;     // or the program's arguments
    std::size_t firstLine = 0;  // of the quoted text, as an index into the page's lines
    std::size_t endLine = 0;    // the closing fence
    std::string text;
};

std::vector<Fence> quotingFences(const std::string& page);

// The definition with the comment above it, its indentation removed. Throws std::runtime_error where there is
// none.
std::string findDefinition(const std::string& source, const std::string& definition);

// What the fence should hold. Quotes of the program stay as they are where it is not built.
std::string quoted(const Fence& fence);

// The page with every quoting fence holding what its source says now.
std::string withFreshQuotes(const std::string& page);

}  // namespace walkcycle::house
