#pragma once

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"

namespace walkcycle {

// Reports elements that would be ignored without a word: those that the schema does not allow in their parent (WC0212), and
// the second and further ones if it allows one (WC0213). Skips elements that programs may fill as they like (<extra>,
// <technique profile>), elements of other namespaces, and parts of the format that Walkcycle does not read.
void checkElements(XmlNode collada, Diagnostics& diagnostics);

}  // namespace walkcycle
