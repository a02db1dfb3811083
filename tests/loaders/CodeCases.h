#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loaders/LoadText.h"

namespace walkcycle {

// How a code of the catalogue comes about: a document that is wrong in one place, which it is about.
struct CodeCase {
    Code code;
    std::string document;  // an @ stands before the damage, and is not part of it
    std::string path;      // of the damaged element
    LoadOptions options{};
    bool isOnDisk = false;  // in a folder of its own, where paths mean something
};

std::vector<CodeCase> documentCases();   // 01xx
std::vector<CodeCase> referenceCases();  // 02xx
std::vector<CodeCase> geometryCases();   // 03xx
std::vector<CodeCase> skinCases();       // 04xx
std::vector<CodeCase> animationCases();  // 05xx
std::vector<CodeCase> materialCases();   // 06xx
std::vector<CodeCase> sceneCases();      // 07xx and 08xx

// ---- making them

// The text with an @ before the first place that begins like this.
inline std::string damagedAt(std::string text, std::string_view part) {
    return text.insert(std::min(text.find(part), text.size()), "@");
}

// A document that shows the geometry "mesh".
inline std::string showing(const std::string& libraries) {
    return collada(libraries + scene("<node id='n'>\n<instance_geometry url='#mesh'/>\n</node>"));
}

// The same with a <geometry> "mesh" of three positions and what `primitives` are made of.
inline std::string meshOf(const std::string& primitives, const std::string& positions = "0 0 0 1 0 0 0 1 0") {
    return showing("<library_geometries><geometry id='mesh'><mesh>\n" + floatSource("p", positions) +
                   "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>\n" + primitives +
                   "</mesh></geometry></library_geometries>\n");
}

// Other files, for documents in memory.
inline FileResolver files(std::map<std::string, std::string> texts) {
    return [texts = std::move(texts)](const std::string& path) -> std::optional<Bytes> {
        const auto found = texts.find(path);
        return found == texts.end() ? std::nullopt : std::optional(bytesOf(found->second));
    };
}

}  // namespace walkcycle
