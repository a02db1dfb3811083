#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace walkcycle {

// The texts of the catalogue (DiagnosticCodes.inc) have placeholders such as {0:ELEMENT}: the number of an argument, and a
// word that `explain` shows in its place. Replaces each placeholder by replacement(number, word).
template <typename Replacement>
std::string replacePlaceholders(std::string_view text, Replacement replacement) {
    std::string filled;
    while (!text.empty()) {
        const std::size_t end = text.find('}');
        const bool isPlaceholder = text[0] == '{' && text.size() > 2 && text[1] >= '0' && text[1] <= '9' &&
                                   text[2] == ':' && end != std::string_view::npos;
        if (!isPlaceholder) {
            filled += text[0];
            text.remove_prefix(1);
            continue;
        }
        filled += replacement(static_cast<std::size_t>(text[1] - '0'), text.substr(3, end - 3));
        text.remove_prefix(end + 1);
    }
    return filled;
}

// For `explain` and docs/diagnostics.md: "<{0:ELEMENT}> has no <{1:CHILD}>" becomes "<ELEMENT> has no <CHILD>".
inline std::string withWords(std::string_view text) {
    return replacePlaceholders(text, [](std::size_t, std::string_view word) { return std::string(word); });
}

}  // namespace walkcycle
