#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/ModelFacts.h"
#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

// The findings of `check` in one file.
struct CheckReport {
    std::string file;
    std::vector<Diagnostic> diagnostics;
    bool readable = true;  // the file could be opened
    bool loaded = false;   // something of the file can be shown
    std::string version, authoringTool;
    std::vector<std::string> profiles;  // names of the profiles whose rules were checked
    ModelFacts facts;                   // set if `loaded`
};

// One line about a file: "hero.dae: 1 error, 2 warnings, 0 notes".
std::string summary(const CheckReport& report);

// One line with the sums over several files.
std::string total(const std::vector<CheckReport>& reports);

// The reports as JSON, with the field names of the glTF validator so that its tools can read them: one
// object, or an array of objects.
std::string reportsJson(const std::vector<CheckReport>& reports, bool asArray);

}  // namespace walkcycle
