#pragma once

#include <string>

#include "app/Arguments.h"
#include "app/Messages.h"
#include "walkcycle/loaders/LoadOptions.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// The options of the loader, which every verb that reads a document has.
struct LoadArguments {
    LoadOptions options;
    bool strict = false;  // end with exit code 1 if the file has errors or warnings
    bool verbose = false;
    bool quiet = false;

    void declare(Arguments& arguments);
    Verbosity verbosity() const {
        return quiet ? Verbosity::Quiet : verbose ? Verbosity::Verbose : Verbosity::Normal;
    }

    // Loads a file, and prints what is wrong with it. Throws LoadError (after printing the reason) and, with
    // --strict, StrictFailure.
    Model load(const std::string& file) const;

    // The same without printing diagnostics, and without StrictFailure. The progress is shown on a terminal.
    Model loadSilently(const std::string& file) const;

private:
    bool noConvert_ = false;
    void declareLimits(Arguments& arguments);
};

// Thrown with --strict if the file has errors or warnings. They have been printed.
struct StrictFailure {};

}  // namespace walkcycle
