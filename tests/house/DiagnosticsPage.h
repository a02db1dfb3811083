#pragma once

#include <string>

namespace walkcycle::house {

// docs/diagnostics.md, made from the catalogue in src/loaders/document/DiagnosticCodes.inc.
std::string diagnosticsPage();

}  // namespace walkcycle::house
