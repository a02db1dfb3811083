#pragma once

#include <span>
#include <string>

#include "loaders/Diagnostics.h"
#include "loaders/LoadOptions.h"
#include "model/Model.h"

namespace walkcycle {

// Reads a COLLADA document (.dae, .zae, gzip; "-": standard input) into a Model. Throws LoadError where nothing can
// be shown; everything else that is wrong is in Model::diagnostics. Two loads may run at once.
Model loadCollada(const std::string& path, const LoadOptions& options = {});

// The same from memory. `name` stands for the file in messages and for relative references.
Model loadCollada(std::span<const std::uint8_t> bytes, const std::string& name,
                  const LoadOptions& options = {});

}  // namespace walkcycle
