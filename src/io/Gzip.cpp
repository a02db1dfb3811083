#include <algorithm>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>

#include <zlib.h>

#include "io/Archive.h"

namespace walkcycle {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

// zlib's inflate for gzip files. The destructor ends it.
class Inflater {
public:
    explicit Inflater(const Bytes& bytes) {
        if (inflateInit2(&stream_, 16 + MAX_WBITS) != Z_OK) throw ArchiveError("zlib cannot start");
        stream_.next_in = const_cast<Bytef*>(bytes.data());  // zlib does not write there
        stream_.avail_in = static_cast<uInt>(bytes.size());
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() { inflateEnd(&stream_); }
    z_stream& stream() { return stream_; }

private:
    z_stream stream_{};
};

void checkSize(const Bytes& unpacked, std::size_t packed, const ArchiveLimits& limits) {
    if (unpacked.size() > limits.maxTotalBytes)
        throw ArchiveTooLarge(
            "it unpacks to over the limit of " + std::to_string(limits.maxTotalBytes) + " bytes",
            unpacked.size(), &ArchiveLimits::maxTotalBytes);
    const std::uint64_t ratio = (unpacked.size() + packed - 1) / packed;
    if (unpacked.size() > kChunk && ratio > limits.maxRatio)
        throw ArchiveTooLarge("it unpacks to more than " + std::to_string(limits.maxRatio) +
                                  " times its size; real files do not compress so far",
                              ratio, &ArchiveLimits::maxRatio);
}

}  // namespace

bool looksLikeGzip(const Bytes& bytes) {
    return bytes.size() >= 3 && bytes[0] == 0x1F && bytes[1] == 0x8B && bytes[2] == 8;
}

Bytes gunzip(const Bytes& bytes, const ArchiveLimits& limits) {
    if (bytes.size() > UINT_MAX) throw ArchiveError("it is over 4 GB");
    Inflater inflater(bytes);
    z_stream& stream = inflater.stream();
    Bytes unpacked;
    while (true) {
        const std::size_t used = unpacked.size();
        unpacked.resize(used + kChunk);
        stream.next_out = unpacked.data() + used;
        stream.avail_out = static_cast<uInt>(kChunk);
        const int result = inflate(&stream, Z_NO_FLUSH);
        unpacked.resize(unpacked.size() - stream.avail_out);
        checkSize(unpacked, bytes.size(), limits);
        const bool anotherMember =
            stream.avail_in > 2 && stream.next_in[0] == 0x1F && stream.next_in[1] == 0x8B;
        if (result == Z_STREAM_END && !anotherMember) return unpacked;
        if (result == Z_STREAM_END) {
            inflateReset(&stream);
        } else if (result == Z_MEM_ERROR) {
            throw std::bad_alloc();
        } else if (result != Z_OK) {
            throw ArchiveError(result == Z_BUF_ERROR ? "the gzip data are cut short"
                                                     : "the gzip data are damaged");
        }
    }
}

}  // namespace walkcycle
