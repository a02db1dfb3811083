#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/XmlNode.h"

namespace walkcycle {

// A Name_array is a list of words, but some exporters (3ds Max's, of "Bip01 L Thigh") write names with spaces into it.
// The words joined into `count` names, each of which is a sid, name or id of a <node> of the document; nothing where
// that does not come out.
std::optional<std::vector<std::string>> joinSpacedNames(const std::vector<std::string_view>& words,
                                                        std::size_t count, XmlNode collada);

}  // namespace walkcycle
