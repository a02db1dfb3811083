#include "app/Shots.h"

#include <algorithm>
#include <cstddef>

#include <glm/gtc/constants.hpp>

#include "app/Clips.h"
#include "app/ExitCode.h"
#include "app/Numbers.h"
#include "app/SharedOptions.h"

namespace walkcycle {
namespace {

constexpr int kMostFrames = 1'000'000;
constexpr int kMostCells = 64;

std::pair<int, int> parseFrames(const std::string& text) {
    const std::size_t dots = text.find("..");
    const auto number = [&](const std::string& part) {
        return parseInteger(part, "--frames", -kMostFrames, kMostFrames);
    };
    if (dots == std::string::npos) throw UsageError("--frames: '" + text + "' is not a range such as 0..23");
    const std::pair<int, int> range{number(text.substr(0, dots)), number(text.substr(dots + 2))};
    if (range.second < range.first) throw UsageError("--frames: '" + text + "' ends before it begins");
    return range;
}

}  // namespace

void ShotList::declare(Arguments& arguments) {
    arguments.group("Which pictures");
    declareTimes(arguments, times_);
    arguments.option("--frames", "A..B", "Frames A to B; frame 0 is at 0 s",
                     [this](const std::string& text) { frames_ = parseFrames(text); });
    arguments.option("--fps", "N", "Frames per second of --frames (24)", [this](const std::string& text) {
        framesPerSecond_ = parseNumber(text, "--fps");
        if (!(framesPerSecond_ > 0.0)) throw UsageError("--fps: '" + text + "' is not over zero");
    });
    arguments.option(
        "--sheet", "CxR", "One picture of C by R moments; without times, they are spread over the clip",
        [this](const std::string& text) { sheet_ = parsePair(text, 'x', "--sheet", kMostCells); });
    arguments.option(
        "--turntable", "N", "N pictures from all sides, the camera moving around the model",
        [this](const std::string& text) { turntable_ = parseInteger(text, "--turntable", 1, kMostFrames); });
}

void ShotList::addFrames(std::vector<double>& times) const {
    for (int frame = frames_.first; frame <= frames_.second; ++frame)
        times.push_back(frame / framesPerSecond_);
}

// The times of the pictures in seconds: from the start of the clip that --clip names, else on the document's timeline.
// documentTime() converts both.
std::vector<double> ShotList::times(const Animation* clip, const std::string& wantedClip) const {
    std::vector<double> times = times_;
    addFrames(times);
    if (!times.empty()) return times;
    const double shift = documentTime(0.0, clip, wantedClip);
    const double start = clip ? clip->startSeconds - shift : 0.0;
    if (!isSheet() || turntable_ > 0) return {start};
    // The cells are spread over the clip evenly, without its end, because the end of a cycle is its start again.
    const int cells = sheet_.first * sheet_.second;
    const double length = clip ? clip->lengthInSeconds() : 0.0;
    for (int cell = 0; cell < cells; ++cell) times.push_back(start + length * cell / cells);
    return times;
}

std::vector<Shot> ShotList::shots(const Animation* clip, const std::string& wantedClip) const {
    const std::vector<double> all = times(clip, wantedClip);
    std::vector<Shot> shots;
    // On a turntable, picture i is of time i; when there are no more times, the last time is repeated.
    const std::size_t count = turntable_ > 0 ? static_cast<std::size_t>(turntable_) : all.size();
    for (std::size_t i = 0; i < count; ++i) {
        Shot shot{.documentSeconds = documentTime(all[std::min(i, all.size() - 1)], clip, wantedClip)};
        if (turntable_ > 0)
            shot.orbitRadians = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(turntable_);
        shots.push_back(shot);
    }
    return shots;
}

}  // namespace walkcycle
