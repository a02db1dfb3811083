#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace walkcycle {

// White space separates the words of a text, whatever the locale. All control characters count as white space, since
// exporters have written all of them.
constexpr bool isWhiteSpace(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

// The text without the white space at both ends.
std::string_view trim(std::string_view text);

// All words, in order; views into `text`.
std::vector<std::string_view> splitWords(std::string_view text);
std::uint64_t countWords(std::string_view text);
// Where word n begins, counted from 0; npos if the text has fewer words.
std::size_t startOfWord(std::string_view text, std::size_t n);

// Makes a file's text fit for a one-line message: at most 200 bytes, control characters replaced by spaces.
std::string printable(std::string_view text);

}  // namespace walkcycle
