#pragma once

#include <string>
#include <vector>

namespace walkcycle {

// The program `walkcycle`: picks the verb, runs it, and turns whatever is thrown into one line and an exit code.
int runProgram(std::vector<std::string> arguments);

}  // namespace walkcycle
