#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/ModelFacts.h"
#include "model/Diagnostic.h"

namespace walkcycle {

// What `check` found out about one file.
struct CheckReport {
    std::string file;
    std::vector<Diagnostic> diagnostics;
    bool readable = true;  // the file could be opened at all
    bool loaded = false;   // something of it could be shown
    std::string version, authoringTool;
    ModelFacts facts;
};

// The report with the glTF validator's field names, for tools that read those.
std::string reportsJson(const std::vector<CheckReport>& reports);

}  // namespace walkcycle
