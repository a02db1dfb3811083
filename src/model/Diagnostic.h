#pragma once

#include <string>

namespace walkcycle {

enum class Severity { Info, Warning, Error };

// Its word in messages, lists and pages.
constexpr const char* nameOf(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "info";
}

// A message about a file, from which its author can fix it.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;         // "WC0207"
    std::string file;         // as the user named it
    int line = 0;             // 1-based; 0 where the fault has no line
    std::string elementPath;  // "COLLADA/library_controllers/controller[id=body]/skin"
    std::string message;
    std::string cure;
    int repeats = 0;  // how many more of this kind were found and left out
};

// "file:line: severity code: message, in library_geometries/geometry[id=body]/mesh (cure)". A long path loses its
// beginning, but never its last element with an id; elementPath has all of it.
std::string toString(const Diagnostic& diagnostic);

}  // namespace walkcycle
