#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace walkcycle {

// What must be known of a document's text before tinyxml2 parses it.

// Processing instructions (<?xml-stylesheet ...?>) are for other programs. tinyxml2 takes them for declarations, which it
// allows at the document's start only; so they are taken out before, and only their line breaks stay. Nothing where the
// document has none.
std::optional<std::string> withoutInstructions(std::string_view document);

// Each new attribute of a tag is compared with all before it, so that a tag of a megabyte would take minutes.
inline constexpr std::size_t kMostAttributes = 1000;

// Where the first tag begins that has more than so many attributes; npos if none does.
std::size_t findCrowdedTag(std::string_view document, std::size_t mostAttributes);

// Where the first element begins that is one too many; npos if there are no more than `most`. Comments and the like count
// as elements, since they take memory as well.
std::size_t findMarkupBeyond(std::string_view document, std::uint64_t most);

}  // namespace walkcycle
