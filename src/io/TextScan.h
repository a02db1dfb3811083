#pragma once

#include <cstddef>
#include <string_view>

namespace walkcycle {

// Fast scans of long texts: the compiler makes vector code of them, which looks at 16 or more characters at a
// time.

std::size_t countLineBreaks(std::string_view text);  // line feeds

// The position of the first character from `from` on that is not ASCII; the text's size if there is none.
std::size_t findBeyondAscii(std::string_view text, std::size_t from = 0);

// The same for control characters that XML 1.0, section 2.2, forbids: all but tab, line feed and carriage
// return.
std::size_t findForbiddenControl(std::string_view text);

// Whether a text is ASCII without forbidden control characters, as nearly all documents are. One pass checks
// both.
bool isPlainText(std::string_view text);

}  // namespace walkcycle
