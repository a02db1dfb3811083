#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "io/Archive.h"
#include "io/TestFolder.h"

namespace walkcycle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Entry {
    std::string name;
    std::string content;
    bool packed = false;
};

void put(Bytes& out, std::uint32_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

void put(Bytes& out, const std::string& text) {
    out.insert(out.end(), text.begin(), text.end());
}

std::string deflated(const std::string& text, int windowBits) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

// A zip archive byte by byte, so that names and sizes can be what no honest program writes.
Bytes zipOf(const std::vector<Entry>& entries, std::uint32_t claimedSize = 0) {
    Bytes file, directory;
    for (const Entry& entry : entries) {
        const std::string data = entry.packed ? deflated(entry.content, -MAX_WBITS) : entry.content;
        const std::uint32_t offset = static_cast<std::uint32_t>(file.size());
        Bytes common;
        put(common, 20, 2);
        put(common, 0, 2);
        put(common, entry.packed ? 8 : 0, 2);
        put(common, 0, 4);
        put(common,
            static_cast<std::uint32_t>(
                crc32_z(0, reinterpret_cast<const Bytef*>(entry.content.data()), entry.content.size())),
            4);
        put(common, static_cast<std::uint32_t>(data.size()), 4);
        put(common, claimedSize ? claimedSize : static_cast<std::uint32_t>(entry.content.size()), 4);
        put(common, static_cast<std::uint32_t>(entry.name.size()), 2);
        put(common, 0, 2);
        put(file, 0x04034b50, 4);
        file.insert(file.end(), common.begin(), common.end());
        put(file, entry.name);
        put(file, data);
        put(directory, 0x02014b50, 4);
        put(directory, 20, 2);
        directory.insert(directory.end(), common.begin(), common.end());
        directory.resize(directory.size() + 10, 0);  // no comment, no disk, no attributes
        put(directory, offset, 4);
        put(directory, entry.name);
    }
    const std::uint32_t start = static_cast<std::uint32_t>(file.size()),
                        count = static_cast<std::uint32_t>(entries.size());
    file.insert(file.end(), directory.begin(), directory.end());
    put(file, 0x06054b50, 4);
    put(file, 0, 4);
    put(file, count, 2);
    put(file, count, 2);
    put(file, static_cast<std::uint32_t>(directory.size()), 4);
    put(file, start, 4);
    put(file, 0, 2);
    return file;
}

TEST(ArchiveTest, membersAreListedAndRead) {
    const Archive archive(zipOf({{"walk.dae", "<COLLADA/>", true}, {"maps/skin.png", "png"}}), {});
    EXPECT_THAT(archive.names(), ElementsAre("walk.dae", "maps/skin.png"));
    EXPECT_EQ(archive.read("walk.dae"), bytesOf("<COLLADA/>"));
    EXPECT_EQ(archive.read("maps/skin.png"), bytesOf("png"));
    EXPECT_FALSE(archive.contains("skin.png"));
    EXPECT_THROW(archive.read("skin.png"), ArchiveError);
}

TEST(ArchiveTest, theManifestNamesTheDocument) {
    const std::string manifest =
        "<?xml version='1.0'?><!-- <dae_root>a.dae</dae_root> --><dae_root xmlns='x'> "
        "./b%20%26%20c.dae#scene\n</dae_root>";
    const Archive archive(zipOf({{"a.dae", ""}, {"b & c.dae", ""}, {"manifest.xml", manifest}}), {});
    EXPECT_EQ(archive.rootDocument(), "b & c.dae");
}

TEST(ArchiveTest, withoutAUsableManifestTheFirstDocumentNearestTheTopIsMeant) {
    EXPECT_EQ(Archive(zipOf({{"deep/a.dae", ""}, {"b.DAE", ""}, {"c.dae", ""}}), {}).rootDocument(), "b.DAE");
    EXPECT_EQ(
        Archive(zipOf({{"a.dae", ""}, {"manifest.xml", "<dae_root>gone.dae</dae_root>"}}), {}).rootDocument(),
        "a.dae");
    EXPECT_EQ(Archive(zipOf({{"a.dae", ""}, {"manifest.xml", "<dae_root"}}), {}).rootDocument(), "a.dae");
    EXPECT_THROW(Archive(zipOf({{"a.obj", ""}}), {}).rootDocument(), ArchiveError);
}

TEST(ArchiveTest, whatTheManifestLeavesOpenIsSaid) {
    const auto doubtOf = [](const std::string& manifest, bool hasTwo) {
        std::string doubt;
        if (manifest.empty() && hasTwo)
            Archive(zipOf({{"a.dae", ""}, {"b.dae", ""}}), {}).rootDocument(&doubt);
        else if (manifest.empty())
            Archive(zipOf({{"a.dae", ""}}), {}).rootDocument(&doubt);
        else
            Archive(zipOf({{"a.dae", ""}, {"manifest.xml", manifest}}), {}).rootDocument(&doubt);
        return doubt;
    };
    EXPECT_EQ(doubtOf("<dae_root>a.dae</dae_root>", false), "");
    EXPECT_EQ(doubtOf("", false), "");
    EXPECT_EQ(doubtOf("", true), "it has several documents and no manifest.xml");
    EXPECT_EQ(doubtOf("<dae_root>gone.dae</dae_root>", false), "'gone.dae' of manifest.xml is not in it");
    EXPECT_EQ(doubtOf("<other/>", false), "manifest.xml names no document");
}

TEST(ArchiveTest, namesThatLeadOutsideAreNotMembers) {
    const Archive archive(zipOf({{"../../etc/passwd", "x"},
                                 {"/etc/passwd", "x"},
                                 {"a/../../b", "x"},
                                 {"maps\\skin.png", "x"},
                                 {"a..b", "x"}}),
                          {});
    EXPECT_THAT(archive.names(), ElementsAre("maps/skin.png", "a..b"));
}

TEST(ArchiveTest, theNumberOfEntriesIsLimited) {
    const Bytes bytes = zipOf({{"a", ""}, {"b", ""}, {"c", ""}});
    EXPECT_EQ(Archive(bytes, {.maxEntries = 3}).names().size(), 3u);
    EXPECT_THROW(Archive(bytes, {.maxEntries = 2}), ArchiveError);
}

TEST(ArchiveTest, theBytesOfAllMembersTogetherAreLimited) {
    const Bytes bytes = zipOf({{"a", "12345"}, {"b", "12345"}});
    EXPECT_EQ(Archive(bytes, {.maxTotalBytes = 10}).names().size(), 2u);
    EXPECT_THROW(Archive(bytes, {.maxTotalBytes = 9}), ArchiveError);
}

TEST(ArchiveTest, aBombIsRefusedByItsRatio) {
    const Archive archive(zipOf({{"zeros.dae", std::string(4 << 20, '\0'), true}}), {});
    EXPECT_THAT([&] { archive.read("zeros.dae"); },
                ThrowsMessage<ArchiveError>(HasSubstr("unpacks to 4194304")));
}

TEST(ArchiveTest, aSizeThatIsNotTrueIsAnError) {
    EXPECT_THROW(Archive(zipOf({{"a", "12345", true}}, 100), {}).read("a"), ArchiveError);
    EXPECT_THROW(Archive(zipOf({{"a", "12345", true}}, 2), {}).read("a"), ArchiveError);
}

TEST(ArchiveTest, anArchiveCutOrChangedAnywhereThrowsOrReads) {
    const Bytes whole =
        zipOf({{"a.dae", "<COLLADA/>", true}, {"manifest.xml", "<dae_root>a.dae</dae_root>"}});
    const auto tryToRead = [](const Bytes& bytes) {
        try {
            const Archive archive(bytes, {});
            archive.read(archive.rootDocument());
        } catch (const ArchiveError&) {
        }
    };
    for (std::size_t i = 0; i < whole.size(); ++i) {
        tryToRead({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i)});
        for (const int bit : {1, 0x80}) {
            Bytes changed = whole;
            changed[i] = static_cast<std::uint8_t>(changed[i] ^ bit);
            tryToRead(changed);
        }
    }
}

TEST(GzipTest, gzipIsUnpackedAlsoInSeveralMembers) {
    const Bytes once = bytesOf(deflated("<COLLADA/>", 16 + MAX_WBITS));
    ASSERT_TRUE(looksLikeGzip(once));
    EXPECT_EQ(gunzip(once, {}), bytesOf("<COLLADA/>"));
    Bytes twice = once;
    twice.insert(twice.end(), once.begin(), once.end());
    EXPECT_EQ(gunzip(twice, {}), bytesOf("<COLLADA/><COLLADA/>"));
}

TEST(GzipTest, bombsAndDamageAreRefused) {
    const Bytes bomb = bytesOf(deflated(std::string(8 << 20, '\0'), 16 + MAX_WBITS));
    EXPECT_THROW(gunzip(bomb, {}), ArchiveError);
    EXPECT_EQ(gunzip(bomb, {.maxRatio = 2000}).size(), std::size_t{8 << 20});
    EXPECT_THROW(gunzip(bomb, {.maxTotalBytes = 1000, .maxRatio = 2000}), ArchiveError);
    Bytes cut = bytesOf(deflated("a document that is long enough to be cut", 16 + MAX_WBITS));
    cut.resize(cut.size() - 12);
    EXPECT_THROW(gunzip(cut, {}), ArchiveError);
    cut.resize(5);
    EXPECT_THROW(gunzip(cut, {}), ArchiveError);
}

TEST(ArchiveTest, kindsAreToldByTheirFirstBytes) {
    EXPECT_TRUE(looksLikeZip(zipOf({{"a", ""}})));
    EXPECT_FALSE(looksLikeZip(bytesOf("<COLLADA/>")));
    EXPECT_FALSE(looksLikeGzip(bytesOf("<COLLADA/>")));
    EXPECT_FALSE(looksLikeZip({}));
}

}  // namespace
}  // namespace walkcycle
