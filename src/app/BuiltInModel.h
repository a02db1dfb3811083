#pragma once

#include <string>

namespace walkcycle {

// The path of the character that comes with the program, walker.dae: in the folder res beside the program (in a build
// folder, a link to the source tree), or in the data folder of the installation. Throws UsageError if it is in neither.
std::string builtInModel();

}  // namespace walkcycle
