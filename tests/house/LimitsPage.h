#pragma once

#include <string>

namespace walkcycle::house {

// docs/limits.md as include/walkcycle/loaders/LoadLimits.h makes it.
std::string limitsPage();

}  // namespace walkcycle::house
