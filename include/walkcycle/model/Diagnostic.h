#pragma once

#include <string>

#include <walkcycle/Export.h>

namespace walkcycle {

// Info: unusual, but read as its author means it. Warning: the library had to guess. Error: a part of the
// file is lost, or shown wrong.
enum class Severity { Info, Warning, Error };

// "info", "warning", "error".
constexpr const char* nameOf(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "info";
}

// A message about a file, from which its author can fix it. docs/diagnostics.md lists all codes. A code keeps
// its meaning in later versions.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;         // "WC0207"
    std::string file;         // as the caller named it; the path of another document if the fault is there
    int line = 0;             // 1-based; 0 if the fault has no line
    std::string elementPath;  // "COLLADA/library_controllers/controller[id=body]/skin"
    std::string message;      // one line, without file and code
    std::string cure;         // how to fix it, in a few words; may be empty
    int repeats = 0;          // how many more faults of this kind were found but not listed
};

// One line: "file:line: severity code: message, in library_geometries/geometry[id=body]/mesh (cure)". A long
// element path loses its beginning, but not its last element with an id; elementPath is complete.
WALKCYCLE_API std::string toString(const Diagnostic& diagnostic);

}  // namespace walkcycle
