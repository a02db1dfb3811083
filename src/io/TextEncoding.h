#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/File.h"

namespace walkcycle {

// Bytes that are no text in the encoding they claim; the message names the offset.
struct EncodingError : std::runtime_error {
    EncodingError(const std::string& what, int lineNumber) : std::runtime_error(what), line(lineNumber) {}
    int line;  // 1-based
};

// The document as UTF-8 without a byte order mark. Understands UTF-8, UTF-16 in both byte orders (with a
// mark, or told by the first bytes of "<?xml"), and ISO-8859-1 / Windows-1252 where the XML declaration names
// them. Lines stay lines, and the declaration of the result says utf-8. Throws EncodingError where the bytes
// are none of these or not valid in the encoding they claim. With `guessed`, 8-bit text that is not what it
// claims is read as Windows-1252, which takes any byte, and *guessed says that this was done. Zero bytes after the
// text are dropped; *padded says so.
std::string toUtf8(Bytes bytes, bool* guessed = nullptr, bool* padded = nullptr);

// The bytes themselves as that text, where they are already what toUtf8 would make of them (the declaration may spell
// the encoding as it likes); nothing where they are not. *plain says whether isPlainText is true of it.
std::optional<std::string_view> asUtf8(const Bytes& bytes, bool* plain = nullptr);

bool isUtf8(std::string_view text);

}  // namespace walkcycle
