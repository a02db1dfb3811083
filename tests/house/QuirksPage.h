#pragma once

#include <string>

namespace walkcycle::house {

// The section of docs/collada-notes.md that src/loaders/quirks/Quirks.h makes, from its heading on.
std::string quirksSection();

// The page with its section (from that heading to the next of its level) replaced by the one above.
std::string withQuirksSection(const std::string& page);

}  // namespace walkcycle::house
