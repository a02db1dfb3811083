#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "walkcycle/io/File.h"

namespace walkcycle {

// The limits on what an archive unpacks to. A file of a few kilobytes may claim gigabytes.
struct ArchiveLimits {
    std::uint64_t maxTotalBytes = std::uint64_t{1} << 30;  // unpacked, all entries together
    std::uint64_t maxEntries = 10000;
    std::uint64_t maxRatio = 200;  // unpacked / packed, for entries over a megabyte
};

// An archive or one of its entries cannot be read. In what(), "it" is the archive: callers put its name
// before.
struct ArchiveError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The archive exceeds one of ArchiveLimits.
struct ArchiveTooLarge : ArchiveError {
    ArchiveTooLarge(const std::string& what, std::uint64_t found, std::uint64_t ArchiveLimits::*passed)
        : ArchiveError(what), amount(found), limit(passed) {}
    std::uint64_t amount;                 // the number that exceeds the limit
    std::uint64_t ArchiveLimits::*limit;  // the exceeded limit
};

// A .zae archive (a zip file) in memory, read with libzip. Entries are named as stored, with "/" between
// folders. Entries whose names lead out of the archive are left out.
class Archive {
public:
    Archive(Bytes bytes, const ArchiveLimits& limits);
    ~Archive();
    Archive(Archive&&) noexcept;

    const std::vector<std::string>& names() const;
    bool contains(const std::string& name) const;
    Bytes read(const std::string& name) const;  // throws ArchiveError
    // The document that <dae_root> of manifest.xml names; otherwise, the .dae in the fewest folders. If that
    // is a guess, *doubt gets the reason. Throws ArchiveError if there is no document.
    std::string rootDocument(std::string* doubt = nullptr) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Whether a file begins like a zip file, or like a gzip file.
bool looksLikeZip(const Bytes& bytes);
bool looksLikeGzip(const Bytes& bytes);
// Unpacks a gzip file. Throws ArchiveError.
Bytes gunzip(const Bytes& bytes, const ArchiveLimits& limits);

}  // namespace walkcycle
