#pragma once

#include <string>
#include <vector>

namespace walkcycle {

// The program `walkcycle`: finds the verb, runs it, and returns the exit code. Prints every exception as a message of
// one line. `arguments` are those of main() without the name of the program.
int runProgram(std::vector<std::string> arguments);

}  // namespace walkcycle
