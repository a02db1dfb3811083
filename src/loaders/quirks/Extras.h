#pragma once

#include <vector>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The <technique>s of an element's <extra>s, where programs write data that the format has no elements for. The profile's
// name differs between programs, the elements inside hardly do, so all profiles are read.
std::vector<XmlNode> extraTechniques(XmlNode owner);

}  // namespace walkcycle
