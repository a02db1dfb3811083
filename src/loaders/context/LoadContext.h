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

// The objects that all loaders of one load share.
struct LoadContext {
    const LoadOptions& options;
    Diagnostics& diagnostics;
    DocumentSet& documents;
    SourceReader& sources;
    Dialects& dialects;                // which quirks of exporters the documents are read with
    LoadProgress* progress = nullptr;  // null: progress is not reported

    // Throws LoadError WC0801 if `amount` is over the limit, as in require(corners, &LoadLimits::maxVertices, p).
    void require(std::uint64_t amount, std::uint64_t LoadLimits::*limit, const XmlNode& where) const;
    // Throws LoadError WC0802 if the caller cancelled.
    void checkCancelled(const XmlNode& where) const;
    // Adds finished work of the current stage (see LoadProgress). Throws LoadError WC0802 if the caller cancelled.
    void advance(double work) const;
    // advance() as a callback for parseNumbers().
    PieceRead pieceRead() const;
};

}  // namespace walkcycle
