#pragma once

#include <span>
#include <string>

#include "model/Diagnostic.h"

namespace walkcycle {

// How much is said on standard error.
enum class Verbosity {
    Quiet,   // only what stopped the program
    Normal,  // errors and warnings
    Verbose  // all of it, and what the program itself chose (device, files found)
};

// One line on standard error, "walkcycle: error: ...".
void printError(const std::string& message);
void printNote(const std::string& message);

// Diagnostics as toString() writes them, a line each, with the option that helps behind the cure; in colour where standard error is a terminal and NO_COLOR
// is not set.
void printDiagnostics(std::span<const Diagnostic> diagnostics, Severity least);

struct DiagnosticCounts {
    int errors = 0, warnings = 0, infos = 0;
};
DiagnosticCounts count(std::span<const Diagnostic> diagnostics);  // repeats are counted too

// Text to standard output, all of it or a FileError.
void printOut(const std::string& text);

// "loading 42 %" on a terminal, from half a second on; cleared by its destructor.
class Progress {
public:
    Progress(std::string what, bool wanted);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }
    bool isShown() const { return wanted_; }  // false: nobody looks, and nothing need be worked out
    void update(double share);
    void clear();

private:
    std::string what_;
    bool wanted_;
    int shown_ = -1;  // percent
    double start_;
};

}  // namespace walkcycle
