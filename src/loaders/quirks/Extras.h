#pragma once

#include <vector>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The <technique>s of an element's <extra>s: programs write there what the format has no words for. The name of the
// profile differs between programs, the words inside hardly do, so every profile is read.
std::vector<XmlNode> extraTechniques(XmlNode owner);

}  // namespace walkcycle
