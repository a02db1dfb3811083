#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/ModelFacts.h"
#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

// What `check` found in one file.
struct CheckReport {
    std::string file;
    std::vector<Diagnostic> diagnostics;
    bool readable = true;  // the file could be opened
    bool loaded = false;   // something of the file can be shown
    std::string version, authoringTool;
    std::vector<std::string> profiles;  // names of the profiles whose rules were checked
    ModelFacts facts;
};

// One line each: "hero.dae: 1 error, 2 warnings, 0 notes", and the sum over several files.
std::string summary(const CheckReport& report);
std::string total(const std::vector<CheckReport>& reports);

// The reports as JSON, with the field names of the glTF validator so that its tools can read them: one
// object, or an array of objects.
std::string reportsJson(const std::vector<CheckReport>& reports, bool asArray);

}  // namespace walkcycle
