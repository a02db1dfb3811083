#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "walkcycle/io/File.h"

namespace walkcycle {

struct ArchiveLimits {
    std::uint64_t maxTotalBytes = std::uint64_t{1} << 30;  // unpacked, all entries together
    std::uint64_t maxEntries = 10000;
    std::uint64_t maxRatio = 200;  // unpacked / packed, for entries over a megabyte
};

struct ArchiveError : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The archive exceeds one of ArchiveLimits.
struct ArchiveTooLarge : ArchiveError {
    ArchiveTooLarge(const std::string& what, std::uint64_t found, std::uint64_t ArchiveLimits::*passed)
        : ArchiveError(what), amount(found), limit(passed) {}
    std::uint64_t amount;
    std::uint64_t ArchiveLimits::*limit;
};

// A .zae (zip) archive in memory, read with libzip. Names are as stored, with '/' between folders.
class Archive {
public:
    Archive(Bytes bytes, const ArchiveLimits& limits);
    ~Archive();
    Archive(Archive&&) noexcept;

    const std::vector<std::string>& names() const;
    bool contains(const std::string& name) const;
    Bytes read(const std::string& name) const;  // throws ArchiveError
    // The document that <dae_root> of manifest.xml names; without one, the .dae that lies in the fewest
    // folders. Where that is a guess, `doubt` says why.
    std::string rootDocument(std::string* doubt = nullptr) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

bool looksLikeZip(const Bytes& bytes);
bool looksLikeGzip(const Bytes& bytes);
Bytes gunzip(const Bytes& bytes, const ArchiveLimits& limits);  // throws ArchiveError

}  // namespace walkcycle
