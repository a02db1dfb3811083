#pragma once

#include <string>

#include "loaders/document/Diagnostics.h"

namespace walkcycle {

// The catalogue's entry for a code that a user typed: "WC0207", "wc0207" and "207" mean the same. Null if
// there is none.
const CodeInfo* codeNamed(const std::string& wanted);

}  // namespace walkcycle
