#pragma once

#include <span>
#include <string>

#include "walkcycle/model/Diagnostic.h"

namespace walkcycle {

// How much is printed on standard error.
enum class Verbosity {
    Quiet,   // only what stops the program
    Normal,  // errors and warnings
    Verbose  // also notes, and what the program chose (device, files found)
};

// One line on standard error, "walkcycle: error: ...".
void printError(const std::string& message);
void printNote(const std::string& message);

// Prints diagnostics of at least this severity, a line each, as toString() gives them with the option that helps behind
// the cure; in colour if standard error is a terminal and NO_COLOR is not set.
void printDiagnostics(std::span<const Diagnostic> diagnostics, Severity least);

struct DiagnosticCounts {
    int errors = 0, warnings = 0, infos = 0;
};
DiagnosticCounts count(std::span<const Diagnostic> diagnostics);  // repeats included

// Writes all of the text to standard output, or throws FileError.
void printOut(const std::string& text);

// Shows "loading 42 %" on a terminal, once half a second has passed. The destructor clears it.
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
