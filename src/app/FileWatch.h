#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace walkcycle {

// Notices when a file was written anew.
class FileWatch {
public:
    explicit FileWatch(std::string path);

    // True once after each change, as soon as the file has not changed for a moment: exporters write in many
    // steps.
    bool changed(double nowInSeconds);

private:
    struct State {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(const State&) const = default;
    };
    std::optional<State> look() const;

    std::string path_;
    std::optional<State> known_, latest_;
    double latestSince_ = 0.0;
    double nextLook_ = 0.0;
};

}  // namespace walkcycle
