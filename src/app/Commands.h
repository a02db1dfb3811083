#pragma once

#include <string>
#include <vector>

#include "app/Arguments.h"

namespace walkcycle {

// The verbs, in the order of the program's help. A new verb is a row here, and a file that defines its
// function: for `view` that is viewCommand() in ViewCommand.cpp.
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

// The versions of the program and of its libraries, and the OpenGL of this machine.
std::string versionText();

}  // namespace walkcycle
