#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/DocumentSet.h"
#include "loaders/document/XmlNode.h"

namespace walkcycle {

// An <input> of a <mesh>'s primitive, <vertices>, <joints>, <vertex_weights>, <targets> or <sampler>.
struct Input {
    std::string semantic;
    int offset = 0;
    int set = 0;
    bool hasSet = false;
    XmlNode element;
    XmlNode source;  // the element that it refers to; nothing if there is none (already reported)
};

// Reports an <input> without a semantic, or with one that is not in `known` (words separated by spaces). An unknown
// semantic is a warning if it looks misspelt, otherwise an info: programs may have semantics of their own.
void checkSemantic(XmlNode input, std::string_view known, Diagnostics& diagnostics);

// All <input>s of an element, with their references resolved. A reference that leads nowhere is reported.
std::vector<Input> readInputs(XmlNode parent, DocumentSet& documents, Diagnostics& diagnostics);

}  // namespace walkcycle
