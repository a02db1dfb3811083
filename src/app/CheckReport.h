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
    std::vector<std::string> profiles;  // whose rules were applied, too
    ModelFacts facts;
};

// "hero.dae: 1 error, 2 warnings, 0 notes", and what that comes to for several files; each one line.
std::string summary(const CheckReport& report);
std::string total(const std::vector<CheckReport>& reports);

// The reports with the glTF validator's field names, for tools that read those: one object, or an array of them.
std::string reportsJson(const std::vector<CheckReport>& reports, bool asArray);

}  // namespace walkcycle
