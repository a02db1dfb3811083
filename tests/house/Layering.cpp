#include "Layering.h"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>

#include "SourceTree.h"

namespace walkcycle::house {
namespace {

using Folders = std::set<std::string>;

// Folder -> the folders of src it may include. "all" may include everything; what is not named here, nothing.
// `model` may also include io/Image.h, and no more of io: a model holds decoded pictures.
const std::map<std::string, Folders> kMayInclude{
    {"animation", {}},
    {"model", {"animation"}},
    {"io", {}},
    {"loaders", {"animation", "model", "io"}},
    {"profiles", {"animation", "model", "io", "loaders"}},
    {"render", {"animation", "model", "io"}},
    {"platform", {}},
    {"export", {"animation", "model", "io"}},
    {"app", {"all"}},
    {"walkcycle", {"all"}},  // the header that library users include
};

// How a library's headers begin -> the only folders that may use it.
const std::vector<std::pair<std::string, Folders>> kLibraries{
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

std::string folderOf(const std::string& path) {
    return path.substr(0, path.find('/'));
}

std::optional<std::string> projectIncludeFault(const std::string& folder, const std::string& included) {
    const auto rule = kMayInclude.find(folder);
    if (rule == kMayInclude.end()) return "the folder '" + folder + "' has no place in the layers";
    const std::string target = folderOf(included);
    const bool isPicture = folder == "model" && included == "io/Image.h";
    if (target == folder || isPicture || rule->second.contains(target) || rule->second.contains("all")) {
        return std::nullopt;
    }
    return folder + " may not include " + included;
}

std::optional<std::string> libraryFault(const std::string& folder, const std::string& included) {
    for (const auto& [prefix, users] : kLibraries) {
        if (included.starts_with(prefix) && !users.contains(folder)) {
            return folder + " may not use <" + included + ">";
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::string> layeringFaults(const std::string& path, const std::string& text) {
    static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    const std::string folder = folderOf(path.substr(std::string("src/").size()));
    std::vector<std::string> faults;
    int lineNumber = 0;
    for (const std::string& line : splitLines(text)) {
        ++lineNumber;
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        const std::string included = match[2];
        const bool isOurs = kMayInclude.contains(folderOf(included));
        const auto fault = isOurs ? projectIncludeFault(folder, included) : libraryFault(folder, included);
        if (fault) faults.push_back(path + ":" + std::to_string(lineNumber) + ": " + *fault);
    }
    return faults;
}

}  // namespace walkcycle::house
