#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "walkcycle/animation/Animation.h"

namespace walkcycle {

// Evaluates a channel of an Animation in double, for the rows that TimelineBuilder writes.
class ExactChannel {
public:
    enum class Side { Left, Right };  // of a jump: just before it, or from it on
    // The curve of one number over an interval: coefficients of 1, s, s², s³, with s from 0 to 1.
    using Cubic = std::array<double, 4>;
    // The curves of rotation (x, y, z, w; not normalised), position and scale.
    using Cubics = std::array<Cubic, 10>;

    explicit ExactChannel(const Channel& channel);

    bool isMatrix() const { return channel_->keyFrames.empty(); }
    bool isCubic() const { return !channel_->tangents.empty(); }

    // The times at which the channel needs rows: its keys, and as many times between them as
    // ClipTimeline::kMaxHalfAngle demands.
    const std::vector<double>& times() const { return times_; }
    // The times at which it jumps, rising.
    const std::vector<double>& jumps() const { return jumps_; }

    ExactTransform transformAt(double seconds, Side side) const;
    glm::dmat4 matrixAt(double seconds, Side side) const;
    // The curves from `begin` to `end`. No key may lie between the two.
    Cubics cubicsBetween(double begin, double end) const;

private:
    struct Key {
        double seconds;
        bool step;
    };
    struct Between {
        std::size_t from = 0, to = 0;  // both the same if that key holds
        double progression = 0.0;
    };
    Between keysAround(double seconds, Side side) const;

    const Channel* channel_;
    std::vector<Key> keys_;
    std::vector<double> times_, jumps_;
};

}  // namespace walkcycle
