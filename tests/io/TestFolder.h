#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "walkcycle/io/File.h"

namespace walkcycle {

// A folder of its own for one test, gone afterwards.
class TestFolder {
public:
    TestFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "walkcycle-test-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
        std::filesystem::remove_all(path_, ignored);
    }
    std::string operator/(const std::string& name) const { return path_ + "/" + name; }
    const std::string& path() const { return path_; }
    std::size_t fileCount() const {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++count;
        return count;
    }

private:
    std::string path_;
};

inline Bytes bytesOf(std::string_view text) {
    return {text.begin(), text.end()};
}

}  // namespace walkcycle
