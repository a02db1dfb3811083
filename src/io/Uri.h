#pragma once

#include <string>
#include <string_view>

namespace walkcycle {

// A URI reference of a document, taken apart: "../maps/skin%20a.png#x" has path "../maps/skin a.png" and
// fragment "x".
struct Uri {
    std::string scheme;    // lower case; empty for a relative reference
    std::string path;      // percent escapes decoded, backslashes replaced by slashes
    std::string fragment;  // decoded
};

Uri parseUri(std::string_view text);

// The text with its percent escapes decoded; an escape that is not two hex digits stays as it is.
std::string percentDecode(std::string_view text);

}  // namespace walkcycle
