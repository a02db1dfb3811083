#include "io/Uri.h"

#include <algorithm>
#include <cstddef>

namespace walkcycle {
namespace {

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

int hexDigit(char c) {
    if (isDigit(c)) return c - '0';
    c = lower(c);
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

// The length of "scheme" in "scheme:..."; 0 if there is none. A single letter is a drive, not a scheme.
std::size_t schemeLength(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || colon < 2 || !isLetter(text[0])) return 0;
    const bool valid =
        std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon),
                    [](char c) { return isLetter(c) || isDigit(c) || c == '+' || c == '-' || c == '.'; });
    return valid ? colon : 0;
}

bool startsWithDrive(std::string_view path) {
    return path.size() >= 2 && isLetter(path[0]) && path[1] == ':';
}

// "///home/x" is the absolute path /home/x; "///C:/x" is C:/x on a drive. Exporters that write "//x.png" mean
// x.png beside the document, not a host of that name.
std::string_view pathOfFileScheme(std::string_view path) {
    if (!path.starts_with("//")) return path;
    path.remove_prefix(2);
    if (path.starts_with("localhost/")) path.remove_prefix(9);
    if (path.starts_with('/') && startsWithDrive(path.substr(1))) path.remove_prefix(1);
    return path;
}

}  // namespace

Uri parseUri(std::string_view text) {
    text = trimmed(text);
    Uri uri;
    if (const std::size_t hash = text.find('#'); hash != std::string_view::npos) {
        uri.fragment = percentDecode(text.substr(hash + 1));
        text = text.substr(0, hash);
    }
    if (const std::size_t length = schemeLength(text); length > 0) {
        uri.scheme = text.substr(0, length);
        std::transform(uri.scheme.begin(), uri.scheme.end(), uri.scheme.begin(), lower);
        text = text.substr(length + 1);
    }
    std::string path(text);
    std::replace(path.begin(), path.end(), '\\', '/');
    uri.path = percentDecode(uri.scheme == "file" ? pathOfFileScheme(path) : path);
    // Exporters on Windows write backslashes as %5C.
    std::replace(uri.path.begin(), uri.path.end(), '\\', '/');
    return uri;
}

std::string percentDecode(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escape =
            text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
        decoded += escape ? static_cast<char>(hexDigit(text[i + 1]) * 16 + hexDigit(text[i + 2])) : text[i];
        if (escape) i += 2;
    }
    return decoded;
}

}  // namespace walkcycle
