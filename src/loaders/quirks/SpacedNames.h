#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "loaders/document/XmlNode.h"

namespace walkcycle {

// The quirk spaced-names: joins the words of a Name_array into `count` names, each of which is a sid, name or id of a
// <node> of the document. Returns nothing if that is not possible.
std::optional<std::vector<std::string>> joinSpacedNames(const std::vector<std::string_view>& words,
                                                        std::size_t count, XmlNode collada);

}  // namespace walkcycle
