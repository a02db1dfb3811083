#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/Archive.h"
#include "loaders/document/Diagnostics.h"
#include "loaders/document/XmlNode.h"
#include "walkcycle/loaders/LoadLimits.h"

namespace walkcycle {

// Throw LoadError WC0801 if `amount` is over the limit: at an element, or at a line of a file that is not parsed yet.
void requireWithin(const LoadLimits& limits, std::uint64_t LoadLimits::*limit, std::uint64_t amount,
                   const XmlNode& where, Diagnostics& diagnostics);
void requireWithin(const LoadLimits& limits, std::uint64_t LoadLimits::*limit, std::uint64_t amount,
                   const std::string& file, int line, Diagnostics& diagnostics);

// The four parts of "1025 bytes of a file are over the limit file-bytes=1024".
struct LimitWords {
    LimitWords(std::uint64_t found, const LoadLimits& limits, std::uint64_t LoadLimits::*limit);
    std::string amount, unit, name, value;
};

// "1025 bytes of a file are over the limit file-bytes=1024", for a load that goes on without the file.
std::string limitText(std::uint64_t amount, const LoadLimits& limits, std::uint64_t LoadLimits::*limit);

// Those of the limits that io applies to archives.
ArchiveLimits archiveLimits(const LoadLimits& limits);

// The limit that an exception of io is about.
std::uint64_t LoadLimits::*limitOf(const ArchiveTooLarge& error);
std::uint64_t LoadLimits::*limitOf(const ImageTooLarge& error);

// Before a document is parsed: limits the number of elements in its text. Comments and other markup count, too.
void requireFewElements(std::string_view text, const std::string& file, const LoadLimits& limits,
                        Diagnostics& diagnostics);

// After that: limits how deep the elements are nested, and how many words the text of each holds.
void requireModestElements(XmlNode root, std::size_t documentBytes, const LoadLimits& limits,
                           Diagnostics& diagnostics);

}  // namespace walkcycle
