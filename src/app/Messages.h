#pragma once

#include <span>
#include <string>

#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

// How much is printed on standard error.
enum class Verbosity {
    Quiet,   // only what stops the program
    Normal,  // errors and warnings
    Verbose  // also notes, and the choices of the program (device, files found)
};

// Print one line on standard error: "walkcycle: error: MESSAGE" and "walkcycle: MESSAGE".
void printError(const std::string& message);
void printNote(const std::string& message);

// Prints diagnostics of at least this severity on standard error, a line each: toString(), with the option that helps
// (OptionHints.h). In colour if standard error is a terminal and NO_COLOR is not set.
void printDiagnostics(std::span<const Diagnostic> diagnostics, Severity least);

struct DiagnosticCounts {
    int errors = 0, warnings = 0, infos = 0;
};

// Counts diagnostics. One that stands for several (Diagnostic::repeats) counts as often as it occurred.
DiagnosticCounts count(std::span<const Diagnostic> diagnostics);

// Writes all of the text to standard output, or throws FileError.
void printOut(const std::string& text);

// Shows "loading 42 %" on standard error if that is a terminal, and only after half a second. The destructor clears it.
class Progress {
public:
    Progress(std::string what, bool wanted);  // `what` is like "loading"
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress() { clear(); }
    bool isShown() const { return wanted_; }  // if false, update() does nothing
    void update(double share);                // of the work that is done: 0 to 1
    void clear();

private:
    std::string what_;
    bool wanted_;
    int shown_ = -1;  // percent
    double start_;
};

}  // namespace walkcycle
