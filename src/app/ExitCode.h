#pragma once

#include <stdexcept>

namespace walkcycle {

// What the program's exit codes mean; scripts rely on them.
enum ExitCode : int {
    kFine = 0,
    kFaultsFound = 1,   // `check` found errors, nothing could be shown, or pictures differ
    kWrongUsage = 2,    // or a file that cannot be read or written
    kNoGraphics = 3,    // no device or display to draw with, or it went away
    kInterrupted = 130  // by SIGINT; as a shell counts, 128 + the signal
};

// The command line asks for something that there is not; the message says what there is.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace walkcycle
