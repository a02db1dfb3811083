#pragma once

#include <string>

namespace walkcycle {

// The path of the character that comes with the program: beside the program, in the installed data folder, or
// in the source tree. Throws UsageError if it is in none of them.
std::string builtInModel();

}  // namespace walkcycle
