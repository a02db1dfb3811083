#pragma once

#include <stdexcept>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/model/Diagnostic.h>

namespace walkcycle {

// Thrown by loadCollada if nothing of the file can be shown, or if the caller cancelled. what() is the reason in one
// line, as toString(Diagnostic) writes it.
struct WALKCYCLE_API LoadError : std::runtime_error {
    // `all` must not be empty; its last entry is the reason.
    explicit LoadError(std::vector<Diagnostic> all);

    // Why the load stopped.
    const Diagnostic& reason() const { return diagnostics.back(); }

    // Whether LoadOptions::cancelled stopped the load. The file may be valid then.
    bool cancelled() const;

    std::vector<Diagnostic> diagnostics;  // everything reported about the file; the reason is the last entry
};

}  // namespace walkcycle
