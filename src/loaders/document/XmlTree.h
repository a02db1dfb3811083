#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace tinyxml2 {
class XMLElement;
}

namespace walkcycle {

// The data that all elements of one parsed document share.
struct XmlTree {
    std::string file;
    bool hasPrefixes = true;  // false: no element's name has a namespace prefix
    std::unordered_map<std::string_view, const tinyxml2::XMLElement*> byId;
};

}  // namespace walkcycle
