#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace walkcycle {

// Notices that a file was written again, by its time and size.
class FileWatch {
public:
    explicit FileWatch(std::string path);

    // Returns true once after each change, when the file has not changed for 0.4 s, because exporters write in many
    // steps. Looks at the file at most five times a second. `nowInSeconds` is from any clock that only rises.
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
