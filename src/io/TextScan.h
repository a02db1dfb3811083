#pragma once

#include <cstddef>
#include <string_view>

namespace walkcycle {

// Fast scans of long texts. The compiler vectorises them, so that they look at 16 or more characters at a
// time.

// The number of line feeds.
std::size_t countLineBreaks(std::string_view text);

// The position of the first character at or after `from` that is not ASCII; the size of the text if there is
// none.
std::size_t findBeyondAscii(std::string_view text, std::size_t from = 0);

// The position of the first control character that XML 1.0 forbids (section 2.2): any but tab, line feed and
// carriage return. The size of the text if there is none.
std::size_t findForbiddenControl(std::string_view text);

// Whether a text is ASCII without forbidden control characters, as nearly all documents are. One pass checks
// both.
bool isPlainText(std::string_view text);

}  // namespace walkcycle
