#pragma once

#include <string>
#include <vector>

#include "app/Arguments.h"

namespace walkcycle {

// The verbs, in the order of the program's help. For a new verb, add a row here and a file with its function: `view`
// has viewCommand() in ViewCommand.cpp.
#define WALKCYCLE_VERBS(ROW) \
    ROW(view)                \
    ROW(render)              \
    ROW(info)                \
    ROW(check)               \
    ROW(pose)                \
    ROW(compare)             \
    ROW(explain)

#define WALKCYCLE_DECLARE(verb) Command verb##Command();
WALKCYCLE_VERBS(WALKCYCLE_DECLARE)
#undef WALKCYCLE_DECLARE

// All verbs, each with its name.
std::vector<Command> allCommands();

// The text of --version: the versions of the program and of its libraries, and the OpenGL of this machine.
std::string versionText();

}  // namespace walkcycle
