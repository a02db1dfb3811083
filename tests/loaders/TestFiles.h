#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "walkcycle/io/File.h"

namespace walkcycle {

// A folder of its own for one test, gone with it.
class TestFolder {
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::string write(const std::string& name,
                      std::string_view text) const;  // makes its folders too; gives the path
    std::string path(const std::string& name) const { return (root_ / name).string(); }

private:
    std::filesystem::path root_;
};

// Archives whose members are stored as they are, so that no packer is needed.
Bytes zipOf(const std::vector<std::pair<std::string, std::string>>& members);
Bytes gzipOf(std::string_view text);

}  // namespace walkcycle
