#include "loaders/TestFiles.h"

#include <atomic>
#include <cstddef>
#include <cstdint>

#include <unistd.h>

namespace walkcycle {
namespace fs = std::filesystem;
namespace {

std::uint32_t crc32(std::string_view text) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : text) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1u ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

void put(Bytes& bytes, std::uint64_t value, int size) {  // the low byte first, as both formats have it
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(i < 8 ? value >> (8 * i) : 0));
}

void put(Bytes& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

// What a member's own header and its entry in the directory both hold.
void putMember(Bytes& bytes, const std::string& name, const std::string& text) {
    put(bytes, 10, 2);  // version needed
    put(bytes, 0, 8);   // flags, method "stored", time and date
    put(bytes, crc32(text), 4);
    put(bytes, text.size(), 4);
    put(bytes, text.size(), 4);
    put(bytes, name.size(), 2);
    put(bytes, 0, 2);  // no extra field
}

}  // namespace

TestFolder::TestFolder() {
    static std::atomic<int> counter{0};
    root_ = fs::temp_directory_path() /
            ("walkcycle-test-" + std::to_string(::getpid()) + "-" + std::to_string(++counter));
    fs::create_directories(root_);
}

TestFolder::~TestFolder() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
}

std::string TestFolder::write(const std::string& name, std::string_view text) const {
    fs::create_directories((root_ / name).parent_path());
    writeFile(path(name), Bytes(text.begin(), text.end()));
    return path(name);
}

Bytes zipOf(const std::vector<std::pair<std::string, std::string>>& members) {
    Bytes bytes, directory;
    for (const auto& [name, text] : members) {
        put(directory, 0x02014B50, 4);
        put(directory, 10, 2);  // made by
        putMember(directory, name, text);
        put(directory, 0, 10);  // no comment, disk 0, no attributes
        put(directory, bytes.size(), 4);
        put(directory, name);
        put(bytes, 0x04034B50, 4);
        putMember(bytes, name, text);
        put(bytes, name);
        put(bytes, text);
    }
    const std::size_t at = bytes.size();
    bytes.insert(bytes.end(), directory.begin(), directory.end());
    put(bytes, 0x06054B50, 4);
    put(bytes, 0, 4);
    put(bytes, members.size(), 2);
    put(bytes, members.size(), 2);
    put(bytes, directory.size(), 4);
    put(bytes, at, 4);
    put(bytes, 0, 2);
    return bytes;
}

Bytes gzipOf(std::string_view text) {
    Bytes bytes{0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 0xFF};
    for (std::size_t at = 0; at == 0 || at < text.size(); at += 0xFFFF) {  // stored blocks
        const std::string_view block = text.substr(at, 0xFFFF);
        bytes.push_back(at + 0xFFFF >= text.size());
        put(bytes, block.size(), 2);
        put(bytes, ~block.size() & 0xFFFFu, 2);
        put(bytes, block);
    }
    put(bytes, crc32(text), 4);
    put(bytes, text.size(), 4);
    return bytes;
}

}  // namespace walkcycle
