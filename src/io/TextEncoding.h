#pragma once

#include <string>

#include "io/File.h"

namespace walkcycle {

// The document as UTF-8 without a byte order mark. Understands UTF-8, UTF-16 in both byte orders (with a mark, or told
// by the first bytes of "<?xml"), and ISO-8859-1 / Windows-1252 where the XML declaration names them. Throws
// std::runtime_error where the bytes are none of these or not valid in the encoding they claim; the message names the offset.
std::string toUtf8(Bytes bytes);

}  // namespace walkcycle
