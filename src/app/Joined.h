#pragma once

#include <string>
#include <string_view>

namespace walkcycle {

// Several names in one text: "gltf|gazebo|secondlife" with the separator "|".
template <typename Names>
std::string joined(const Names& names, std::string_view separator) {
    std::string text;
    for (const auto& name : names) {
        if (!text.empty()) text += separator;
        text += name;
    }
    return text;
}

}  // namespace walkcycle
