#pragma once

#include <string>

namespace walkcycle {

enum class Severity { Info, Warning, Error };

// The word for it, in messages, lists and pages alike.
constexpr const char* nameOf(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "info";
}

// One thing to say about a file, so that its author can mend it.
struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;         // "WC0207"
    std::string file;         // as the user named it
    int line = 0;             // 1-based; 0 where the fault has no line
    std::string elementPath;  // "COLLADA/library_controllers/controller[id=body]/skin"
    std::string message;
    std::string cure;
    int repeats = 0;  // how many more of the kind were met after this one
};

// "file:line: severity code: message, in library_geometries/geometry[id=body]/mesh (cure)". A long path loses its
// beginning, but never its last element with an id; elementPath has all of it.
std::string toString(const Diagnostic& diagnostic);

}  // namespace walkcycle
