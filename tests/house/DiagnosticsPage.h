#pragma once

#include <string>

namespace walkcycle::house {

// docs/diagnostics.md, made from the catalogue in src/loaders/DiagnosticCodes.inc.
std::string diagnosticsPage();

}  // namespace walkcycle::house
