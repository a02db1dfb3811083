#include "app/Playback.h"

#include <algorithm>

#include "animation/Animator.h"

namespace walkcycle {
namespace {

constexpr double kStepSeconds = 1.0 / 30.0;

}  // namespace

void Playback::start(double lengthInSeconds, double seconds) {
    length_ = lengthInSeconds;
    clock_ = seconds;
}

void Playback::advance(double seconds) {
    if (paused) return;
    clock_ += seconds * speed;
    // Wrapped at once, so that days of playing lose no precision.
    if (mode == LoopMode::Once) clock_ = std::clamp(clock_, 0.0, std::max(length_, 0.0));
    if (mode == LoopMode::Loop) clock_ = loop(clock_, length_);
    if (mode == LoopMode::PingPong) clock_ = loop(clock_, 2.0 * length_);
}

void Playback::step(int direction) {
    paused = true;
    clock_ += direction * kStepSeconds;
}

double Playback::time() const {
    if (mode == LoopMode::Once) return std::clamp(clock_, 0.0, std::max(length_, 0.0));
    if (mode == LoopMode::Loop) return loop(clock_, length_);
    const double there = loop(clock_, 2.0 * length_);
    return there <= length_ ? there : 2.0 * length_ - there;
}

bool Playback::atEnd() const {
    return mode == LoopMode::Once && speed > 0.0 && clock_ >= length_;
}

}  // namespace walkcycle
