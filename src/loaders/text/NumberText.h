#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace walkcycle {

// The text of one element that was cut out of the document.
struct NumberText {
    std::string_view text;  // a view into the document
    int linesInTag = 0;     // line breaks within the start tag, so that the text's own line can be told
};

// Nearly all bytes of a document are numbers, and tinyxml2 walks each of its bytes twice. So the texts of the long lists
// (<float_array>, <p>, <v>, <vcount>, and of names, <Name_array> and <IDREF_array>) are cut out before it sees the
// document; of each only its line breaks stay, so that every line number remains right.
struct CutDocument {
    std::string remaining;
    // One entry per element of those names, in document order: its text, or nothing where the text was left in place
    // (it holds a comment, an entity or CDATA, or the element is empty).
    std::vector<std::optional<NumberText>> texts;
};

bool holdsNumberText(std::string_view elementName);

// Nothing where the document has markup that must be judged as a whole: a DOCTYPE, a tag or comment without end, a tag
// with more than kMostAttributes.
std::optional<CutDocument> cutNumberText(std::string_view document);

}  // namespace walkcycle
