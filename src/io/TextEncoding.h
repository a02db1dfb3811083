#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "walkcycle/io/File.h"

namespace walkcycle {

// The bytes are not text in the encoding that they claim. The message names the offset.
struct EncodingError : std::runtime_error {
    EncodingError(const std::string& what, int lineNumber) : std::runtime_error(what), line(lineNumber) {}
    int line;  // 1-based
};

// Decodes a document to UTF-8 without a byte order mark. Reads UTF-8, UTF-16 in both byte orders (with a
// mark, or recognised by the first bytes of "<?xml"), and ISO-8859-1 / Windows-1252 if the XML declaration
// names them. Line breaks are kept, and the declaration of the result says utf-8. Throws EncodingError if the
// bytes are none of these, or not valid in the encoding that they claim. With `guessed`, 8-bit text that is
// not valid in the encoding that it claims is decoded as Windows-1252, in which every byte is valid, and
// *guessed is set. Zero bytes after the text are dropped, and *padded is set.
std::string toUtf8(Bytes bytes, bool* guessed = nullptr, bool* padded = nullptr);

// The bytes themselves, without a copy, if they are what toUtf8 would return (whichever way the declaration
// spells the encoding); otherwise nothing. *plain is the result of isPlainText().
std::optional<std::string_view> asUtf8(const Bytes& bytes, bool* plain = nullptr);

bool isUtf8(std::string_view text);

}  // namespace walkcycle
