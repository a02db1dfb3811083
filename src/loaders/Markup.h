#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace walkcycle {

// Processing instructions (<?xml-stylesheet ...?>) are for other programs. tinyxml2 takes them for declarations, which it
// allows at the document's start only; so they are to be taken out before, and only their line breaks stay. Nothing where there are none.
std::optional<std::string> withoutInstructions(std::string_view document);

// Where a tag begins that has more than so many attributes; npos if none does. Each new attribute is compared with all
// before it, so that a tag of a megabyte would take minutes.
std::size_t findCrowdedTag(std::string_view document, std::size_t mostAttributes);

}  // namespace walkcycle
