#pragma once

#include <string>
#include <string_view>

namespace walkcycle {

// The parts of a URI reference (RFC 3986): "../maps/skin%20a.png#x" has the path "../maps/skin a.png" and the
// fragment "x".
struct Uri {
    std::string scheme;    // lower case; empty for a relative reference
    std::string path;      // percent escapes decoded, backslashes replaced by slashes
    std::string fragment;  // percent escapes decoded; without "#"
};

// Accepts any text. White space at its ends is ignored, and a drive letter ("C:/x.png") is part of the path.
Uri parseUri(std::string_view text);

// Decodes percent escapes. An escape that is not two hexadecimal digits is left as it is.
std::string percentDecode(std::string_view text);

}  // namespace walkcycle
