#pragma once

#include <string>
#include <vector>

namespace walkcycle::house {

// A source file, with its path relative to the working copy ("src/model/Bounds.cpp").
struct SourceFile {
    std::string path;
    std::string text;
};

// One #include of a file, as it is written: "walkcycle/model/Model.h", "loaders/text/Markup.h", "vector".
struct Include {
    std::string target;
    int line = 0;
};
std::vector<Include> includesOf(const std::string& text);

// The room of a file: its folder below src or include/walkcycle ("model"), and for loaders the folder below that
// ("loaders/curves"; "loaders" for what stands above the rooms).
std::string roomOf(const std::string& path);

// What is wrong with the includes of one file, one sentence each: a room that points the wrong way, past another room's
// door, or a library where it has no business.
std::vector<std::string> layeringFaults(const SourceFile& file);

// The circles among files, one sentence each ("a/A -> b/B -> a/A"). A header and the source of the same name in the same
// room count as one.
std::vector<std::string> circles(const std::vector<SourceFile>& files);

}  // namespace walkcycle::house
