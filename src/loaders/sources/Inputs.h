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
    XmlNode source;  // where it leads; nothing where it leads nowhere (already reported as an error)
};

// Reports an <input> without a semantic, and one that is none of the known (words between spaces): programs may have
// words of their own, so that is an error of the file only where it looks like a slip.
void checkSemantic(XmlNode input, std::string_view known, Diagnostics& diagnostics);

// All <input>s of an element, references followed (and reported as an error where they lead nowhere).
std::vector<Input> readInputs(XmlNode parent, DocumentSet& documents, Diagnostics& diagnostics);

}  // namespace walkcycle
