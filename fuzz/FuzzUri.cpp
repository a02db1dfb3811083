// Any bytes as a URI.

#include <cstddef>
#include <cstdint>
#include <string>

#include "Require.h"
#include "io/Uri.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const walkcycle::Uri uri = walkcycle::parseUri(text);
    REQUIRE(uri.scheme.size() + uri.path.size() + uri.fragment.size() <= text.size());
    REQUIRE(uri.path.find('\\') == std::string::npos);
    for (const char c : uri.scheme) REQUIRE(c < 'A' || c > 'Z');
    const std::string decoded = walkcycle::percentDecode(text);
    REQUIRE(decoded.size() <= text.size());
    if (text.find('%') == std::string::npos) REQUIRE(decoded == text);
    return 0;
}
