#pragma once

#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"

namespace walkcycle {

// Reports what would be dropped without a word: elements that the schema does not know where they stand (WC0212), and
// second ones where it allows one (WC0213). What programs may fill as they like (<extra>, <technique profile>), elements
// of other namespaces, and parts of the format that Walkcycle does not read are let alone.
void checkElements(XmlNode collada, Diagnostics& diagnostics);

}  // namespace walkcycle
