#pragma once

#include <cstdint>

#include "loaders/Diagnostics.h"
#include "loaders/DocumentSet.h"
#include "loaders/LoadLimits.h"
#include "loaders/LoadOptions.h"
#include "loaders/Source.h"
#include "loaders/XmlNode.h"

namespace walkcycle {

// What every loader of one load shares.
struct LoadContext {
    const LoadOptions& options;
    Diagnostics& diagnostics;
    DocumentSet& documents;
    SourceReader& sources;

    // Throws LoadError WC0801 where `amount` is over the limit, as in require(corners, &LoadLimits::maxVertices, p).
    void require(std::uint64_t amount, std::uint64_t LoadLimits::*limit, const XmlNode& where) const;
    void checkCancelled(const XmlNode& where) const;
};

}  // namespace walkcycle
