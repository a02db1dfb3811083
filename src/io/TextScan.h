#pragma once

#include <cstddef>
#include <string_view>

namespace walkcycle {

// Looks over long texts, sixteen characters and more at a time where the machine has vectors.

std::size_t countLineBreaks(std::string_view text);  // line feeds

// Where, from `from` on, the first character stands that is not ASCII; the text's size if all are.
std::size_t findBeyondAscii(std::string_view text, std::size_t from = 0);

// The same for a control character that XML 1.0, section 2.2, forbids: all but tab, line feed and carriage return.
std::size_t findForbiddenControl(std::string_view text);

// Whether a text is ASCII without any of those, as nearly all documents are: both at once.
bool isPlainText(std::string_view text);

}  // namespace walkcycle
