#pragma once

#include <string>

namespace walkcycle {

// The path of the character that comes with the program: beside the binary, where it is installed, or in the source
// tree. Throws UsageError where it is in none of them.
std::string builtInModel();

}  // namespace walkcycle
