#include "app/Commands.h"

namespace walkcycle {

std::vector<Command> allCommands() {
    std::vector<Command> commands;
#define WALKCYCLE_ADD(verb)              \
    commands.push_back(verb##Command()); \
    commands.back().name = #verb;
    WALKCYCLE_VERBS(WALKCYCLE_ADD)
#undef WALKCYCLE_ADD
    return commands;
}

}  // namespace walkcycle
