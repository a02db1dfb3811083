#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "io/TextEncoding.h"

namespace walkcycle {

// Writes JSON directly into a string. A JSON library would make a tree of values first, which costs too much for a pose
// with megabytes of numbers.
class JsonText {
public:
    // Appends the text as it is.
    void raw(std::string_view text) { text_ += text; }

    // Appends a string with its quotes. The name of a file may be any bytes: if they are not UTF-8, they count as
    // Latin-1.
    void string(std::string_view value) {
        const bool valid = isUtf8(value);
        text_ += '"';
        for (const char c : value) character(c, valid);
        text_ += '"';
    }

    // Appends the shortest text that reads back as the same number. JSON has no infinity and no NaN: 0 stands for them.
    template <typename Number>
    void number(Number value) {
        if (!std::isfinite(value)) return raw("0");
        std::array<char, 32> digits;
        const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
        text_.append(digits.data(), result.ptr);
    }

    std::string take() { return std::move(text_); }

private:
    void character(char c, bool valid) {
        constexpr std::string_view kHex = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += c;
        } else if (byte < 0x20 || (byte >= 0x80 && !valid)) {
            text_ += "\\u00";
            text_ += kHex[byte >> 4];
            text_ += kHex[byte & 15];
        } else {
            text_ += c;
        }
    }

    std::string text_;
};

}  // namespace walkcycle
