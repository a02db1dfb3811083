#include "app/Clips.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <vector>

#include "app/ExitCode.h"

namespace walkcycle {
namespace {

bool meansWholeTimeline(const std::string& wanted) {
    return wanted.empty() || wanted == "all";
}

std::string list(const Model& model) {
    if (model.animations.empty()) return "the file has no animation";
    std::string names;
    for (std::size_t i = 0; i < model.animations.size(); ++i)
        names += (i == 0 ? "" : ", ") + std::to_string(i) + " '" + model.animations[i].name + "'";
    return "there are " + names;
}

}  // namespace

const Animation* findClip(const Model& model, const std::string& wanted) {
    const std::vector<Animation>& clips = model.animations;
    const auto named =
        std::find_if(clips.begin(), clips.end(), [&](const Animation& clip) { return clip.name == wanted; });
    if (!wanted.empty() && named != clips.end()) return &*named;
    if (meansWholeTimeline(wanted)) return clips.empty() ? nullptr : &clips.front();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (error == std::errc() && end == wanted.data() + wanted.size() && number < clips.size())
        return &clips[number];
    throw UsageError("--clip: there is no clip '" + wanted + "'; " + list(model));
}

double documentTime(double seconds, const Animation* clip, const std::string& wantedClip) {
    return clip && !meansWholeTimeline(wantedClip) ? clip->startSeconds + seconds : seconds;
}

}  // namespace walkcycle
