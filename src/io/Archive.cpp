#include "io/Archive.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include <zip.h>

#include "io/TextEncoding.h"
#include "io/Uri.h"

namespace walkcycle {
namespace {

constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20;

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

// Whether a name stays inside the archive. Nothing is unpacked to disk, but a path in a document must not
// resolve to another entry either.
bool isHarmless(const std::string& name) {
    if (name.empty() || name.front() == '/' || name.find('\0') != std::string::npos) return false;
    for (std::size_t start = 0; start <= name.size();) {
        const std::size_t end = std::min(name.find('/', start), name.size());
        if (name.substr(start, end - start) == "..") return false;
        start = end + 1;
    }
    return true;
}

// The ratio of unpacked to packed size, rounded up, so that a ratio just over a limit counts as over it.
std::uint64_t timesItsSize(std::uint64_t unpacked, std::uint64_t packed) {
    return packed == 0 ? UINT64_MAX : unpacked / packed + (unpacked % packed != 0);
}

std::string withoutComments(std::string xml) {
    for (std::size_t start; (start = xml.find("<!--")) != std::string::npos;) {
        const std::size_t end = xml.find("-->", start + 4);
        xml.erase(start, end == std::string::npos ? std::string::npos : end + 3 - start);
    }
    return xml;
}

// Decodes "&amp;", the only escape that a path needs.
std::string withAmpersands(std::string_view xml) {
    std::string text;
    for (std::size_t i = 0; i < xml.size(); ++i) {
        text += xml[i];
        if (xml.substr(i).starts_with("&amp;")) i += 4;
    }
    return text;
}

// The entry that <dae_root> of a manifest names. A manifest contains nothing else, so a search for the tag is
// enough.
std::string daeRoot(Bytes manifest) {
    std::string xml = withoutComments(toUtf8(std::move(manifest)));
    const std::size_t element = xml.find("<dae_root");
    const std::size_t start = xml.find('>', element);
    if (element == std::string::npos || start == std::string::npos) return {};
    const std::string text = xml.substr(start + 1, xml.find('<', start) - start - 1);
    std::string path = parseUri(withAmpersands(text)).path;
    while (path.starts_with("./")) path.erase(0, 2);
    while (path.starts_with('/')) path.erase(0, 1);
    return path;
}

struct Member {
    zip_uint64_t index = 0;
    std::uint64_t size = 0;  // unpacked, as the archive claims
    std::uint64_t packedSize = 0;
};

}  // namespace

struct Archive::Impl {
    Bytes bytes;  // libzip reads them as long as the archive is open
    ArchiveLimits limits;
    zip_t* zip = nullptr;
    std::vector<std::string> names;
    std::unordered_map<std::string, Member> members;

    ~Impl() {
        if (zip) zip_discard(zip);
    }
    void open();
    void list();
    Bytes unpack(const std::string& name, const Member& member) const;
};

void Archive::Impl::open() {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source) zip = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (zip) return zip_error_fini(&error);
    if (source) zip_source_free(source);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw ArchiveError("not a readable zip archive: " + reason);
}

void Archive::Impl::list() {
    const zip_int64_t count = zip_get_num_entries(zip, 0);
    if (count < 0) throw ArchiveError("libzip cannot count its entries");
    if (static_cast<std::uint64_t>(count) > limits.maxEntries)
        throw ArchiveTooLarge("it holds " + std::to_string(count) + " entries; the limit is " +
                                  std::to_string(limits.maxEntries),
                              static_cast<std::uint64_t>(count), &ArchiveLimits::maxEntries);
    std::uint64_t total = 0;
    for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
        zip_stat_t stat;
        constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
        if (zip_stat_index(zip, i, 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded) continue;
        std::string name = stat.name;
        std::replace(name.begin(), name.end(), '\\', '/');
        if (!isHarmless(name) || name.back() == '/') continue;
        if (stat.size > limits.maxTotalBytes - total)
            throw ArchiveTooLarge(
                "its files are over the limit of " + std::to_string(limits.maxTotalBytes) + " bytes together",
                stat.size > UINT64_MAX - total ? UINT64_MAX : total + stat.size,
                &ArchiveLimits::maxTotalBytes);
        total += stat.size;
        if (members.emplace(name, Member{i, stat.size, stat.comp_size}).second) names.push_back(name);
    }
}

Bytes Archive::Impl::unpack(const std::string& name, const Member& member) const {
    if (member.size > kMegabyte && timesItsSize(member.size, member.packedSize) > limits.maxRatio)
        throw ArchiveTooLarge("'" + name + "' unpacks to " + std::to_string(member.size) + " bytes from " +
                                  std::to_string(member.packedSize) + "; real files do not compress so far",
                              timesItsSize(member.size, member.packedSize), &ArchiveLimits::maxRatio);
    zip_file_t* file = zip_fopen_index(zip, member.index, 0);
    if (!file) throw ArchiveError("'" + name + "' cannot be unpacked: " + zip_strerror(zip));
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> owner(file, zip_fclose);
    Bytes unpacked;
    while (unpacked.size() <= member.size) {  // grows with the bytes that arrive, not with the claimed size
        const std::size_t used = unpacked.size();
        unpacked.resize(std::min<std::uint64_t>(member.size + 1, used + kMegabyte));
        const zip_int64_t got = zip_fread(file, unpacked.data() + used, unpacked.size() - used);
        if (got < 0) throw ArchiveError("'" + name + "' cannot be unpacked: " + zip_file_strerror(file));
        unpacked.resize(used + static_cast<std::size_t>(got));
        if (got == 0) break;
    }
    if (unpacked.size() != member.size)
        throw ArchiveError("'" + name + "' is not of the size that the archive claims");
    return unpacked;
}

Archive::Archive(Bytes bytes, const ArchiveLimits& limits) : impl_(std::make_unique<Impl>()) {
    impl_->bytes = std::move(bytes);
    impl_->limits = limits;
    impl_->open();
    impl_->list();
}

Archive::~Archive() = default;
Archive::Archive(Archive&&) noexcept = default;

const std::vector<std::string>& Archive::names() const {
    return impl_->names;
}

bool Archive::contains(const std::string& name) const {
    return impl_->members.contains(name);
}

Bytes Archive::read(const std::string& name) const {
    const auto found = impl_->members.find(name);
    if (found == impl_->members.end()) throw ArchiveError("it holds no '" + name + "'");
    return impl_->unpack(name, found->second);
}

std::string Archive::rootDocument(std::string* doubt) const {
    std::string reason;
    for (const std::string& name : names()) {
        if (lowerCase(name) != "manifest.xml") continue;
        const std::string root = daeRoot(read(name));
        if (contains(root)) return root;
        reason =
            root.empty() ? "manifest.xml names no document" : "'" + root + "' of manifest.xml is not in it";
    }
    const std::string* best = nullptr;  // the first .dae in the fewest folders
    const auto depth = [](const std::string& name) { return std::count(name.begin(), name.end(), '/'); };
    for (const std::string& name : names()) {
        if (!lowerCase(name).ends_with(".dae")) continue;
        if (best && reason.empty()) reason = "it has several documents and no manifest.xml";
        if (!best || depth(name) < depth(*best)) best = &name;
    }
    if (!best) throw ArchiveError("it holds no .dae document");
    if (doubt) *doubt = reason;
    return *best;
}

bool looksLikeZip(const Bytes& bytes) {
    return bytes.size() >= 4 && bytes[0] == 'P' && bytes[1] == 'K' &&
           ((bytes[2] == 3 && bytes[3] == 4) || (bytes[2] == 5 && bytes[3] == 6));
}

}  // namespace walkcycle
