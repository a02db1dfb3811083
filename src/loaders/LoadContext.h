#pragma once

#include "loaders/ColladaDocument.h"
#include "loaders/Diagnostics.h"
#include "loaders/LoadOptions.h"
#include "loaders/Source.h"

namespace walkcycle {

class Dialects;
class PicturesAhead;

// What every loader of one load shares.
struct LoadContext {
    const LoadOptions& options;
    Diagnostics& diagnostics;
    DocumentSet& documents;
    SourceReader& sources;
    Dialects& dialects;              // which quirks of exporters the documents are read with
    PicturesAhead* ahead = nullptr;  // where pictures are decoded while meshes are read

    // Throws LoadError WC0801 where `amount` is over the limit, as in require(corners, &LoadLimits::maxVertices, p).
    void require(std::uint64_t amount, std::uint64_t LoadLimits::*limit, const XmlNode& where) const;
    void checkCancelled(const XmlNode& where) const;
};

}  // namespace walkcycle
