#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <walkcycle/Export.h>
#include <walkcycle/loaders/LoadError.h>
#include <walkcycle/loaders/LoadOptions.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// Reads a COLLADA document (1.4.0, 1.4.1, 1.5.0; .dae, .zae or packed by gzip; "-" is standard input) into a Model.
// Faults of the document that leave something to show are listed in Model::diagnostics.
//
// Throws LoadError if nothing can be shown or the caller cancelled, InvalidOption if a value of `options` is not allowed,
// and std::bad_alloc. Exceptions of the options' callbacks reach the caller. Several threads may load at once. A load may
// start threads; they end before it returns.
WALKCYCLE_API Model loadCollada(const std::string& path, const LoadOptions& options = {});

// The same from memory; `bytes` are not needed after the call. Messages call the document `name`, and its references are
// resolved against that path. No file on disk is opened: the document can refer to other files only if it is an archive
// that holds them, or if LoadOptions::resolver is set.
WALKCYCLE_API Model loadCollada(std::span<const std::uint8_t> bytes, const std::string& name,
                                const LoadOptions& options = {});

}  // namespace walkcycle
