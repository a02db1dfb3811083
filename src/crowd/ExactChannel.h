#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "walkcycle/animation/Animation.h"

namespace walkcycle {

// A channel of an Animation, evaluated in double: what TimelineBuilder takes its rows from.
class ExactChannel {
public:
    enum class Side { Left, Right };  // at a jump: just before it, or from it on
    // A number's curve over a stretch of time, s going from 0 to 1: constant, s, s², s³.
    using Cubic = std::array<double, 4>;
    // Of rotation (x, y, z, w; not of unit length), position and scale.
    using Cubics = std::array<Cubic, 10>;

    explicit ExactChannel(const Channel& channel);

    bool isMatrix() const { return channel_->keyFrames.empty(); }
    bool isCubic() const { return !channel_->tangents.empty(); }

    // Where it must have rows: at its keys, and so often between them that a row is never further than
    // ClipTimeline::kMaxHalfAngle from the one before.
    const std::vector<double>& times() const { return times_; }
    const std::vector<double>& jumps() const { return jumps_; }

    ExactTransform transformAt(double seconds, Side side) const;
    glm::dmat4 matrixAt(double seconds, Side side) const;
    // From `begin` to `end`, between which there is no key.
    Cubics cubicsBetween(double begin, double end) const;

private:
    struct Key {
        double seconds;
        bool step;
    };
    struct Between {
        std::size_t from = 0, to = 0;  // the same one where it holds
        double progression = 0.0;
    };
    Between keysAround(double seconds, Side side) const;

    const Channel* channel_;
    std::vector<Key> keys_;
    std::vector<double> times_, jumps_;
};

}  // namespace walkcycle
