#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/Arguments.h"
#include "walkcycle/model/Model.h"

namespace walkcycle {

// One picture to draw: the moment, and the position of the camera on its circle around the model.
struct Shot {
    double documentSeconds = 0.0;  // on the document's timeline
    float orbitRadians = 0.0f;     // how far --turntable has moved the camera around the model
};

// The options of `render` that choose the pictures: --time, --frames, --fps, --sheet and --turntable.
class ShotList {
public:
    void declare(Arguments& arguments);

    bool isSheet() const { return sheet_.first > 0; }
    std::pair<int, int> sheet() const { return sheet_; }  // columns, rows

    // The pictures in their order. `clip` is findClip() of the model, null if nothing moves; `wantedClip` is the
    // value of --clip.
    std::vector<Shot> shots(const Animation* clip, const std::string& wantedClip) const;

private:
    std::vector<double> times(const Animation* clip, const std::string& wantedClip) const;
    void addFrames(std::vector<double>& times) const;

    std::vector<double> times_;          // the values of --time
    std::pair<int, int> frames_{0, -1};  // first and last; none if last < first
    double framesPerSecond_ = 24.0;
    std::pair<int, int> sheet_{0, 0};  // 0: no --sheet
    int turntable_ = 0;                // pictures around the model; 0: no --turntable
};

}  // namespace walkcycle
