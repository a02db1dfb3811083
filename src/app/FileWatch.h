#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace walkcycle {

// Notices that a file was written again.
class FileWatch {
public:
    explicit FileWatch(std::string path);

    // True once after each change, when the file has kept still for a moment: exporters write in many steps.
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
