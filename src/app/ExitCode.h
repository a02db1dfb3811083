#pragma once

#include <stdexcept>

namespace walkcycle {

// The exit codes of the program. Scripts rely on their meaning.
enum ExitCode : int {
    kFine = 0,
    // `check` found errors, nothing of the file can be shown, pictures differ, or memory ran out; with --strict, any
    // error or warning.
    kFaultsFound = 1,
    kWrongUsage = 2,    // the command line is wrong, or a file cannot be read or written
    kNoGraphics = 3,    // no device or display to draw with, or it was lost
    kInterrupted = 130  // by SIGINT: 128 + the number of the signal, as in shells (SIGTERM: 143)
};

// The command line names something that does not exist or is not possible. The message says what is possible.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace walkcycle
