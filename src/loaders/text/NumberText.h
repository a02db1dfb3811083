#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace walkcycle {

// The text of one element that was cut out of the document.
struct NumberText {
    std::string_view text;  // a view into the document
    int linesInTag = 0;     // line breaks within the start tag, to compute the text's line
};

// Nearly all bytes of a document are numbers, and tinyxml2 walks each byte twice. So the texts of the long lists
// (<float_array>, <p>, <v>, <vcount>, and of names, <Name_array> and <IDREF_array>) are cut out before tinyxml2 parses the
// document. Only their line breaks stay, so that all line numbers remain right.
struct CutDocument {
    std::string remaining;  // the document without those texts
    // One entry per element of those names, in document order: its text, or nothing if the text was left in place (it is
    // short, holds a comment, an entity or CDATA, or the element is empty).
    std::vector<std::optional<NumberText>> texts;
};

// Whether it is one of those names.
bool holdsNumberText(std::string_view elementName);

// Returns nothing if a simple scan cannot be trusted: the document has a DOCTYPE, a tag or comment without end, or a tag
// with more than kMostAttributes.
std::optional<CutDocument> cutNumberText(std::string_view document);

}  // namespace walkcycle
