#include "app/BuiltInModel.h"

#include <filesystem>
#include <vector>

#include "app/ExitCode.h"

namespace walkcycle {

std::string builtInModel() {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    const std::vector<fs::path> places = {
        folder / "res",                                          // the build folder, or unpacked anywhere
        folder.parent_path() / WALKCYCLE_DATADIR / "walkcycle",  // <prefix>/bin and <prefix>/share
    };
    for (const fs::path& place : places)
        if (fs::is_regular_file(place / "walker.dae", error)) return (place / "walker.dae").string();
    throw UsageError("the built-in character walker.dae cannot be found; name a file");
}

}  // namespace walkcycle
