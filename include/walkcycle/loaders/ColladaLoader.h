#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <walkcycle/Export.h>
#include <walkcycle/loaders/LoadError.h>
#include <walkcycle/loaders/LoadOptions.h>
#include <walkcycle/model/Model.h>

namespace walkcycle {

// Reads a COLLADA document (1.4.0, 1.4.1, 1.5.0; .dae, .zae or packed by gzip; "-" is standard input) into a Model. What
// is wrong with the document and does not keep the rest from being shown is in Model::diagnostics.
//
// Throws LoadError where nothing can be shown or the caller cancelled, InvalidOption where `options` cannot be used, and
// std::bad_alloc; what a callback of the options throws goes through. Several threads may load at once. A load may start
// threads of its own, which end with it.
WALKCYCLE_API Model loadCollada(const std::string& path, const LoadOptions& options = {});

// The same from memory, which is not needed afterwards. `name` stands for the file in messages, and what the document
// refers to is resolved against it. No file is opened: without LoadOptions::resolver, or an archive of its own, the
// document has no files around it.
WALKCYCLE_API Model loadCollada(std::span<const std::uint8_t> bytes, const std::string& name,
                                const LoadOptions& options = {});

}  // namespace walkcycle
