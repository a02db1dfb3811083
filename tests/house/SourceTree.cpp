#include "SourceTree.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace walkcycle::house {

std::filesystem::path root() {
    return WALKCYCLE_SOURCE_DIR;
}

std::string readText(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

void writeText(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::vector<std::string> splitLines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> filesBelow(const std::string& folder, const std::vector<std::string>& extensions) {
    std::vector<std::string> files;
    const std::filesystem::path start = root() / folder;
    if (!std::filesystem::exists(start)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(start)) {
        const bool wanted = std::ranges::count(extensions, entry.path().extension().string()) > 0;
        if (entry.is_regular_file() && wanted) {
            files.push_back(entry.path().lexically_relative(root()).generic_string());
        }
    }
    std::ranges::sort(files);
    return files;
}

std::string outputOf(const std::string& command) {
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return output;
    char buffer[4096];
    for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, n);
    pclose(pipe);
    return output;
}

bool updatesDocs() {
    const char* wish = std::getenv("UPDATE_DOCS");
    return wish && std::string(wish) == "1";
}

}  // namespace walkcycle::house
