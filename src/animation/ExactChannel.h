#pragma once

#include <array>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "animation/Animation.h"

namespace walkcycle {

// A channel of an Animation, evaluated in double: what TimelineBuilder takes its rows from.
class ExactChannel {
public:
    enum class Side { Left, Right };  // at a jump: just before it, or from it on
    struct Transform {
        glm::dvec3 position{0.0};
        glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
        glm::dvec3 scale{1.0};
    };
    // A number's curve over a stretch of time, s going from 0 to 1: constant, s, s², s³.
    using Cubic = std::array<double, 4>;
    struct Cubics {
        std::array<Cubic, 4> rotation{};  // x, y, z, w; not of unit length
        std::array<Cubic, 3> position{}, scale{};
    };

    explicit ExactChannel(const Channel& channel);

    bool isMatrix() const { return channel_->keyFrames.empty(); }
    bool isCubic() const { return !channel_->tangents.empty(); }
    int joint() const { return channel_->joint; }

    // Where it must have rows: at its keys, and so often between them that no step turns by more than kMaxTurn.
    const std::vector<double>& times() const { return times_; }
    const std::vector<double>& jumps() const { return jumps_; }

    Transform transformAt(double seconds, Side side) const;
    glm::dmat4 matrixAt(double seconds, Side side) const;
    // From `begin` to `end`, between which there is no key.
    Cubics cubicsBetween(double begin, double end) const;

private:
    struct Place {
        std::size_t key = 0, next = 0;  // the same one where it holds
        double progression = 0.0;
    };
    Place placeOf(double seconds, Side side) const;
    double secondsOf(std::size_t key) const;
    bool isStep(std::size_t key) const;
    std::size_t keyCount() const;

    const Channel* channel_;
    std::vector<double> times_, jumps_;
};

}  // namespace walkcycle
