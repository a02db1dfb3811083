#include "app/FileWatch.h"

#include <utility>

namespace walkcycle {
namespace {

constexpr double kSecondsBetweenLooks = 0.2;
constexpr double kSecondsOfQuiet = 0.4;

}  // namespace

FileWatch::FileWatch(std::string path) : path_(std::move(path)), known_(look()), latest_(known_) {}

std::optional<FileWatch::State> FileWatch::look() const {
    std::error_code error;
    State state;
    state.time = std::filesystem::last_write_time(path_, error);
    if (!error) state.size = std::filesystem::file_size(path_, error);
    return error ? std::nullopt : std::optional(state);
}

bool FileWatch::changed(double nowInSeconds) {
    if (nowInSeconds < nextLook_) return false;
    nextLook_ = nowInSeconds + kSecondsBetweenLooks;
    const std::optional<State> state = look();
    if (state != latest_) {
        latest_ = state;
        latestSince_ = nowInSeconds;
    }
    // A file that is gone is being replaced: wait for the new one.
    if (!latest_ || latest_ == known_ || nowInSeconds - latestSince_ < kSecondsOfQuiet) return false;
    known_ = latest_;
    return true;
}

}  // namespace walkcycle
