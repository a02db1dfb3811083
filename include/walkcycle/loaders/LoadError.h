#pragma once

#include <stdexcept>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/model/Diagnostic.h>

namespace walkcycle {

// Thrown by loadCollada where nothing of the file can be shown, and where the caller cancelled. what() is the reason as
// one line, in the form of toString(Diagnostic).
struct WALKCYCLE_API LoadError : std::runtime_error {
    // The last of `all`, of which there must be one, is the reason.
    explicit LoadError(std::vector<Diagnostic> all);

    // Why the load stopped.
    const Diagnostic& reason() const { return diagnostics.back(); }

    // Whether LoadOptions::cancelled stopped it: then the file may be in order.
    bool cancelled() const;

    std::vector<Diagnostic> diagnostics;  // all that was said of the file; the reason is the last
};

}  // namespace walkcycle
