#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "walkcycle/io/File.h"

namespace walkcycle {

// The bytes are not text in the encoding that they declare. what() names the byte offset.
struct EncodingError : std::runtime_error {
    EncodingError(const std::string& what, int lineNumber) : std::runtime_error(what), line(lineNumber) {}
    int line;  // 1-based
};

// Decodes a document to UTF-8 without a byte order mark. Reads UTF-8; UTF-16 in both byte orders (with a byte
// order mark, or recognised by "<?"); and ISO-8859-1 or Windows-1252 if the XML declaration names it. Line
// breaks are kept, and the declaration of the result names utf-8. Throws EncodingError if the bytes are in
// another encoding, or not valid in the one that they declare.
//
// With `guessed`, 8-bit text that is not valid in its encoding is decoded as Windows-1252, in which every
// byte is valid, and *guessed is set. Zero bytes after the text are dropped, and *padded is set.
std::string toUtf8(Bytes bytes, bool* guessed = nullptr, bool* padded = nullptr);

// The bytes themselves, without a copy, if toUtf8 would return the same text (but for the spelling of the
// encoding in the declaration); otherwise nothing. *plain gets the result of isPlainText().
std::optional<std::string_view> asUtf8(const Bytes& bytes, bool* plain = nullptr);

// Whether the text is valid UTF-8.
bool isUtf8(std::string_view text);

}  // namespace walkcycle
