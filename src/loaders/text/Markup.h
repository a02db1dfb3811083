#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace walkcycle {

// Scans of a document's text before tinyxml2 parses it.

// Removes processing instructions (<?xml-stylesheet ...?>) except their line breaks: they are for other programs, and
// tinyxml2 takes them for declarations, which it allows at the document's start only. Returns nothing if there are none.
std::optional<std::string> withoutInstructions(std::string_view document);

// tinyxml2 compares each attribute of a tag with all before it: a tag of a megabyte would take minutes.
inline constexpr std::size_t kMostAttributes = 1000;

// Where the first tag with more than `mostAttributes` attributes begins; npos if there is none.
std::size_t findCrowdedTag(std::string_view document, std::size_t mostAttributes);

// Where the element after the first `most` ones begins; npos if there are no more. Comments and other markup count as
// elements, since they take memory, too.
std::size_t findMarkupBeyond(std::string_view document, std::uint64_t most);

}  // namespace walkcycle
