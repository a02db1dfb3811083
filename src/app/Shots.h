#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/Arguments.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// One picture to take: when, and how far round the model the camera stands.
struct Shot {
    double documentSeconds = 0.0;
    float orbitRadians = 0.0f;  // how far the camera has moved around the model
};

// The options of `render` that say which pictures there are.
class ShotList {
public:
    void declare(Arguments& arguments);

    bool isSheet() const { return sheet_.first > 0; }
    std::pair<int, int> sheet() const { return sheet_; }  // columns, rows

    // `clip` may be null (nothing moves); `wantedClip` is --clip as given.
    std::vector<Shot> shots(const Animation* clip, const std::string& wantedClip) const;

private:
    std::vector<double> times(const Animation* clip, const std::string& wantedClip) const;
    void addFrames(std::vector<double>& times) const;

    std::vector<double> times_;
    std::pair<int, int> frames_{0, -1};
    double framesPerSecond_ = 24.0;
    std::pair<int, int> sheet_{0, 0};
    int turntable_ = 0;
};

}  // namespace walkcycle
