// Any bytes as an archive, zip or gzip.

#include <cstddef>
#include <cstdint>
#include <string>

#include "Require.h"
#include "io/Archive.h"

namespace {

using namespace walkcycle;

constexpr ArchiveLimits kLimits{.maxTotalBytes = 1 << 20, .maxEntries = 64, .maxRatio = 200};

void readAll(const Bytes& bytes) {
    const Archive archive(bytes, kLimits);
    REQUIRE(archive.names().size() <= kLimits.maxEntries);
    std::uint64_t total = 0;
    for (const std::string& name : archive.names()) {
        REQUIRE(archive.contains(name));
        try {
            total += archive.read(name).size();
        } catch (const ArchiveError&) {  // this entry alone
        }
    }
    REQUIRE(total <= kLimits.maxTotalBytes);
    archive.rootDocument();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes(data, data + size);
    try {
        if (looksLikeGzip(bytes)) REQUIRE(gunzip(bytes, kLimits).size() <= kLimits.maxTotalBytes);
    } catch (const ArchiveError&) {
    }
    try {
        readAll(bytes);
    } catch (const ArchiveError&) {
    }
    return 0;
}
