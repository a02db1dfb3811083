#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace walkcycle::house {

std::filesystem::path root();  // of the working copy

std::string readText(const std::filesystem::path& file);
void writeText(const std::filesystem::path& file, const std::string& text);
std::vector<std::string> splitLines(const std::string& text);

// Files below a folder of the working copy with one of these extensions (".h"), sorted, relative to the root.
std::vector<std::string> filesBelow(const std::string& folder, const std::vector<std::string>& extensions);

std::string outputOf(const std::string& command);  // what a shell command prints

// UPDATE_DOCS=1 in the environment: tests of generated pages write them instead of complaining.
bool updatesDocs();

}  // namespace walkcycle::house
