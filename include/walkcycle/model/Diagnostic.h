#pragma once

#include <string>

#include <walkcycle/Export.h>

namespace walkcycle {

// Info: unusual, and handled as it is meant. Warning: the library had to guess. Error: something of the file is lost or
// wrong in what is shown.
enum class Severity { Info, Warning, Error };

// "info", "warning", "error".
constexpr const char* nameOf(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "info";
}

// A message about a file, from which its author can fix it. docs/diagnostics.md lists the codes, which keep their
// meaning.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;  // "WC0207"
    std::string file;  // as the caller named it; another document's path where the fault is in that one
    int line = 0;      // 1-based; 0 where the fault has no line
    std::string elementPath;  // "COLLADA/library_controllers/controller[id=body]/skin"
    std::string message;      // one line, without file and code
    std::string cure;         // what to do about it, in a few words; may be empty
    int repeats = 0;          // how many more of this kind were found and left out
};

// "file:line: severity code: message, in library_geometries/geometry[id=body]/mesh (cure)". A long path loses its
// beginning, but never its last element with an id; elementPath has all of it.
WALKCYCLE_API std::string toString(const Diagnostic& diagnostic);

}  // namespace walkcycle
