#pragma once

#include <cstdint>

#include "loaders/document/Diagnostics.h"
#include "loaders/document/DocumentSet.h"
#include "loaders/document/XmlNode.h"
#include "loaders/sources/Source.h"
#include "loaders/text/NumberParser.h"
#include "walkcycle/loaders/LoadLimits.h"
#include "walkcycle/loaders/LoadOptions.h"

namespace walkcycle {

class Dialects;
class LoadProgress;

// What every loader of one load shares.
struct LoadContext {
    const LoadOptions& options;
    Diagnostics& diagnostics;
    DocumentSet& documents;
    SourceReader& sources;
    Dialects& dialects;                // which quirks of exporters the documents are read with
    LoadProgress* progress = nullptr;  // null: nobody is told

    // Throws LoadError WC0801 where `amount` is over the limit, as in require(corners, &LoadLimits::maxVertices, p).
    void require(std::uint64_t amount, std::uint64_t LoadLimits::*limit, const XmlNode& where) const;
    // Throws LoadError WC0802 where the caller wants no more.
    void checkCancelled(const XmlNode& where) const;
    // So much of the stage's work is done (see LoadProgress); also throws where the caller wants no more.
    void advance(double work) const;
    // The same for who reads numbers.
    PieceRead pieceRead() const;
};

}  // namespace walkcycle
