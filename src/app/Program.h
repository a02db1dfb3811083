#pragma once

#include <string>
#include <vector>

namespace walkcycle {

// The program `walkcycle`: finds the verb, runs it, and turns every exception into a one-line message and an
// exit code.
int runProgram(std::vector<std::string> arguments);

}  // namespace walkcycle
