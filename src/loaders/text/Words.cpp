#include "loaders/text/Words.h"

#include <algorithm>

namespace walkcycle {
namespace {

constexpr std::size_t kLongestPrinted = 200;  // bytes

bool continuesCharacter(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

}  // namespace

std::string_view trim(std::string_view text) {
    while (!text.empty() && isWhiteSpace(text.front())) text.remove_prefix(1);
    while (!text.empty() && isWhiteSpace(text.back())) text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> splitWords(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < text.size();) {
        if (isWhiteSpace(text[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < text.size() && !isWhiteSpace(text[end])) ++end;
        words.push_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

std::uint64_t countWords(std::string_view text) {
    std::uint64_t words = 0;
    bool between = true;
    for (const char c : text) {
        words += between && !isWhiteSpace(c);
        between = isWhiteSpace(c);
    }
    return words;
}

std::size_t startOfWord(std::string_view text, std::size_t n) {
    bool between = true;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool isSpace = isWhiteSpace(text[at]);
        if (between && !isSpace && n-- == 0) return at;
        between = isSpace;
    }
    return std::string_view::npos;
}

std::string printable(std::string_view text) {
    std::size_t length = std::min(text.size(), kLongestPrinted);
    while (length > 0 && length < text.size() && continuesCharacter(text[length])) --length;
    std::string shown(text.substr(0, length));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ' || c == 0x7F) c = ' ';
    return length < text.size() ? shown + "..." : shown;
}

}  // namespace walkcycle
