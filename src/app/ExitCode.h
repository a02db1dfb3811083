#pragma once

#include <stdexcept>

namespace walkcycle {

// The exit codes of the program. Scripts rely on their meaning.
enum ExitCode : int {
    kFine = 0,
    kFaultsFound = 1,   // `check` found errors, nothing could be shown, or pictures differ
    kWrongUsage = 2,    // also: a file cannot be read or written
    kNoGraphics = 3,    // no device or display to draw with, or it was lost
    kInterrupted = 130  // by SIGINT: 128 + the signal's number, as in shells
};

// The command line asks for something that does not exist or is not possible. The message says what is.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace walkcycle
