#include "Layering.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <regex>
#include <set>
#include <utility>

#include "SourceTree.h"

namespace walkcycle::house {
namespace {

using Names = std::set<std::string>;

// A room: which other rooms it may include ("*": all, "loaders/*": all of the loaders), and the headers that other rooms may include of it (none named:
// all of them).
struct Room {
    Names mayInclude;
    Names doors;
};

// The one table of rooms. A room that is not named has no place.
const std::map<std::string, Room> kRooms{
    {"animation", {{}, {}}},
    {"crowd", {{"animation"}, {}}},
    {"io", {{}, {}}},
    {"model", {{"animation"}, {}}},  // and Image.h: a model holds decoded pictures, but reads no files
    {"loaders/text", {{}, {"Words.h", "Spelling.h", "Markup.h", "NumberText.h", "NumberParser.h"}}},
    {"loaders/document",
     {{"loaders/text"},
      {"XmlNode.h", "ColladaDocument.h", "DocumentSet.h", "Diagnostics.h", "DiagnosticCodes.inc",
       "LimitCheck.h", "LoadProgress.h", "KnownElements.h", "MessageTemplate.h"}}},
    {"loaders/quirks",
     {{"loaders/text", "loaders/document"},
      {"Dialect.h", "Quirks.h", "SpacedNames.h", "TransparencyQuirk.h", "Extras.h"}}},
    {"loaders/sources", {{"loaders/text", "loaders/document", "loaders/quirks"}, {"Source.h", "Inputs.h"}}},
    {"loaders/context",
     {{"loaders/text", "loaders/document", "loaders/quirks", "loaders/sources"},
      {"LoadContext.h", "AssetReader.h"}}},
    {"loaders/geometry",
     {{"loaders/text", "loaders/document", "loaders/quirks", "loaders/sources", "loaders/context"},
      {"MeshLibrary.h", "LoadedMesh.h"}}},
    {"loaders/scene",
     {{"loaders/text", "loaders/document", "loaders/quirks", "loaders/sources", "loaders/context"},
      {"SceneGraph.h", "AnimationTargets.h", "SkeletonLoader.h", "SceneLoader.h"}}},
    {"loaders/materials",
     {{"loaders/text", "loaders/document", "loaders/quirks", "loaders/sources", "loaders/context"},
      {"MaterialLoader.h"}}},
    {"loaders/controllers",
     {{"loaders/text", "loaders/document", "loaders/quirks", "loaders/sources", "loaders/context",
       "loaders/geometry", "loaders/scene"},
      {"ControllerLoader.h"}}},
    {"loaders/curves",
     {{"loaders/text", "loaders/document", "loaders/quirks", "loaders/sources", "loaders/context",
       "loaders/scene"},
      {"AnimationLoader.h", "Motion.h", "MatrixParts.h", "StackParts.h", "ClipLoader.h", "ChannelTarget.h"}}},
    {"loaders/keys", {{"loaders/document", "loaders/context", "loaders/curves"}, {"AnimationFitter.h"}}},
    {"loaders", {{"loaders/*"}, {}}},
    {"profiles",
     {{"animation", "model", "loaders", "loaders/text", "loaders/document", "loaders/scene", "loaders/curves",
       "loaders/context"},
      {}}},
    {"platform", {{}, {}}},
    {"render", {{"animation", "model", "io"}, {}}},
    {"app", {{"*"}, {}}},
    {"walkcycle", {{"*"}, {}}},  // walkcycle.h itself, and Export.h
};
// Every room of loaders may include these folders.
const Names kBelowLoaders{"animation", "model", "io", "loaders"};

// How a library's headers begin -> the only rooms that may use it.
const std::vector<std::pair<std::string, Names>> kLibraries{
    {"tinyxml2", {"loaders"}},
    {"epoxy/", {"render", "platform", "app"}},
    {"GL/", {"render", "platform", "app"}},
    {"EGL/", {"platform"}},
    {"GLFW/", {"platform", "app"}},
    {"stb", {"io"}},
    {"png", {"io"}},
    {"webp/", {"io"}},
    {"turbojpeg", {"io"}},
    {"zip", {"io"}},
    {"libdeflate", {"io"}},
    {"zlib", {"io"}},
    {"CLI/", {"app"}},
    {"nlohmann/", {"app", "export"}},
};

std::string topOf(const std::string& room) {
    return room.substr(0, room.find('/'));
}

std::string fileName(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

bool isPublic(const std::string& path) {
    return path.starts_with("include/");
}

// An include of ours as the path of the file that is meant; nothing for a library's.
std::optional<std::string> ourFile(const std::string& target) {
    if (target.starts_with("walkcycle/")) return "include/" + target;
    if (target.find('/') == std::string::npos) return std::nullopt;
    const std::string path = "src/" + target;
    if (kRooms.contains(roomOf(path)) || topOf(target) == "loaders") return path;
    return std::nullopt;
}

bool mayInclude(const std::string& room, const std::string& target) {
    const Names& allowed = kRooms.at(room).mayInclude;
    if (room == target || allowed.contains("*") || allowed.contains(target)) return true;
    if (allowed.contains("loaders/*") && topOf(target) == "loaders") return true;
    return topOf(room) == "loaders" && kBelowLoaders.contains(target);
}

std::optional<std::string> projectFault(const SourceFile& file, const std::string& included) {
    const std::string room = roomOf(file.path), target = roomOf(included);
    if (!kRooms.contains(room)) return "the room '" + room + "' has no place in the layers";
    if (included == "include/walkcycle/Export.h") return std::nullopt;
    if (isPublic(file.path) && !isPublic(included)) return "a public header may not include " + included;
    if (room == "model" && included == "include/walkcycle/io/Image.h") return std::nullopt;
    if (!mayInclude(room, target)) return room + " may not include " + included;
    const Names& doors = kRooms.at(target).doors;
    if (room != target && !doors.empty() && !doors.contains(fileName(included)))
        return fileName(included) + " is no door of " + target;
    return std::nullopt;
}

std::optional<std::string> libraryFault(const SourceFile& file, const std::string& included) {
    for (const auto& [prefix, users] : kLibraries) {
        if (!included.starts_with(prefix)) continue;
        if (isPublic(file.path)) return "a public header may not include <" + included + ">";
        if (!users.contains(topOf(roomOf(file.path))))
            return roomOf(file.path) + " may not use <" + included + ">";
    }
    return std::nullopt;
}

// "src/model/Bounds.cpp" and "include/walkcycle/model/Bounds.h" are both "model/Bounds".
std::string unitOf(const std::string& path) {
    const std::string file = fileName(path);
    return roomOf(path) + '/' + file.substr(0, file.find('.'));
}

// Who includes whom, header and source taken as one: "model/Bounds" -> {"model/Model", ...}. Ours alone.
std::map<std::string, std::vector<std::string>> includeGraph(const std::vector<SourceFile>& files) {
    std::map<std::string, std::vector<std::string>> graph;
    for (const SourceFile& file : files) {
        const std::string unit = unitOf(file.path);
        std::vector<std::string>& targets = graph[unit];
        for (const Include& include : includesOf(file.text)) {
            const auto ours = ourFile(include.target);
            if (!ours || unitOf(*ours) == unit || std::ranges::count(targets, unitOf(*ours)) > 0) continue;
            targets.push_back(unitOf(*ours));
        }
    }
    return graph;
}

}  // namespace

std::string roomOf(const std::string& path) {
    std::string rest = path;
    for (const std::string root : {"include/walkcycle/", "src/"})
        if (rest.starts_with(root)) rest = rest.substr(root.size());
    const std::size_t end = rest.find('/');
    if (end == std::string::npos) return "walkcycle";
    const std::string folder = rest.substr(0, end);
    if (folder != "loaders" || isPublic(path)) return folder;
    const std::size_t roomEnd = rest.find('/', end + 1);
    return roomEnd == std::string::npos ? folder : rest.substr(0, roomEnd);
}

std::vector<Include> includesOf(const std::string& text) {
    static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
    std::vector<Include> includes;
    int line = 0;
    for (const std::string& words : splitLines(text)) {
        ++line;
        std::smatch match;
        if (words.find('#') != std::string::npos && std::regex_match(words, match, include))
            includes.push_back({match[1], line});
    }
    return includes;
}

std::vector<std::string> layeringFaults(const SourceFile& file) {
    std::vector<std::string> faults;
    for (const Include& include : includesOf(file.text)) {
        const auto ours = ourFile(include.target);
        const auto fault = ours ? projectFault(file, *ours) : libraryFault(file, include.target);
        if (fault) faults.push_back(file.path + ":" + std::to_string(include.line) + ": " + *fault);
    }
    return faults;
}

std::vector<std::string> circles(const std::vector<SourceFile>& files) {
    const auto graph = includeGraph(files);
    std::vector<std::string> found, path;
    Names done;
    const std::function<void(const std::string&)> visit = [&](const std::string& unit) {
        const auto onPath = std::ranges::find(path, unit);
        if (onPath != path.end()) {
            std::string circle;
            for (auto step = onPath; step != path.end(); ++step) circle += *step + " -> ";
            found.push_back(circle + unit);
            return;
        }
        const auto targets = graph.find(unit);
        if (targets == graph.end() || !done.insert(unit).second) return;
        path.push_back(unit);
        for (const std::string& target : targets->second) visit(target);
        path.pop_back();
    };
    for (const auto& [unit, targets] : graph) visit(unit);
    return found;
}

}  // namespace walkcycle::house
