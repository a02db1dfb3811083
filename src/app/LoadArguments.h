#pragma once

#include <string>

#include "app/Arguments.h"
#include "app/Messages.h"
#include "loaders/LoadOptions.h"
#include "model/Model.h"

namespace walkcycle {

// The loader's options, which every verb that reads a document takes.
struct LoadArguments {
    LoadOptions options;
    bool strict = false;  // warnings and errors of the file end the program with 1
    bool verbose = false;
    bool quiet = false;

    void declare(Arguments& arguments);
    Verbosity verbosity() const {
        return quiet ? Verbosity::Quiet : verbose ? Verbosity::Verbose : Verbosity::Normal;
    }

    // Loads, and says what is wrong with the file. Throws LoadError (after saying why), and with --strict also
    // where a file could be shown.
    Model load(const std::string& file) const;

    // The same without saying anything.
    Model loadSilently(const std::string& file) const;

private:
    bool noConvert_ = false;
    std::string skinNode_ = "auto";
    void declareLimits(Arguments& arguments);
};

// Thrown by --strict after the messages were printed.
struct StrictFailure {};

}  // namespace walkcycle
