#include "walkcycle/animation/Animator.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "animation/CubicKeys.h"
#include "animation/KeyFrameSearch.h"
#include "animation/MatrixKeys.h"
#include "animation/ParameterTrack.h"

namespace walkcycle {

Animator::Animator(const Skeleton& skeleton, std::span<const float> restParameters)
    : skeleton_(&skeleton),
      restPose_(skeleton),
      pose_(restPose_),
      restParameters_(restParameters.begin(), restParameters.end()),
      parameters_(restParameters_),
      modelTransforms_(skeleton.joints.size()) {
    applyPoseToJoints();
}

// Starts from the rest pose, since the last clip may have moved joints that this one does not.
void Animator::doAnimation(const Animation& animation) {
    animation_ = &animation;
    pose_ = restPose_;
    std::copy(restParameters_.begin(), restParameters_.end(), parameters_.begin());
    const bool startsAtEnd = loopMode_ == LoopMode::Once && speed_ < 0.0;
    setTime(startsAtEnd ? lengthInSeconds() : 0.0);
}

// The video's update(). The caller says how much time went by; the Java asks a static clock.
void Animator::update(double seconds) {
    if (!animation_) return;
    increaseAnimationTime(seconds);
    calculateCurrentAnimationPose(timeInDocument());
    applyPoseToJoints();
}

// Wraps the time at every step, so that days of playing lose no precision.
void Animator::increaseAnimationTime(double seconds) {
    const double length = lengthInSeconds();
    const double time = animationTime_ + seconds * speed_;
    if (std::isnan(time)) return;  // of seconds that are NaN, or infinite at speed 0
    switch (loopMode_) {
        case LoopMode::Once:
            animationTime_ = time > 0.0 ? std::min(time, length) : 0.0;
            break;
        case LoopMode::Loop:
            animationTime_ = loop(time, length);
            break;
        case LoopMode::PingPong:
            animationTime_ = loop(time, 2.0 * length);
            break;
    }
}

// In the Java, a key frame holds all joints. Here each joint that moves has a channel with key frames of its own.
void Animator::calculateCurrentAnimationPose(double documentSeconds) {
    for (const Channel& channel : animation_->channels) {
        const auto joint = static_cast<std::size_t>(channel.joint);
        assert(joint < pose_.size());
        if (!channel.keyFrames.empty()) {
            pose_.set(joint, sample(channel, documentSeconds));
        } else if (!channel.matrixKeyFrames.empty()) {
            pose_.set(joint, sampleMatrix(channel.matrixKeyFrames, documentSeconds));
        }
    }
    for (const ParameterTrack& track : animation_->parameterTracks) {
        const auto parameter = static_cast<std::size_t>(track.parameter);
        if (parameter < parameters_.size() && !track.keyFrames.empty())
            parameters_[parameter] = sample(track, documentSeconds);
    }
}

// The pose of one joint. (Cubic curves between the key frames are beyond the video: CubicKeys.cpp.)
JointTransform sample(const Channel& channel, double seconds) {
    if (!channel.tangents.empty()) return sampleCubic(channel.keyFrames, channel.tangents, seconds);
    const auto [previous, next] = getPreviousAndNextFrames(channel.keyFrames, seconds);
    const float progression = calculateProgression(previous.seconds, next.seconds, seconds);
    return interpolatePoses(previous, next, progression);
}

template <class Key>
PreviousAndNext<Key> getPreviousAndNextFrames(const std::vector<Key>& keyFrames, double seconds) {
    assert(!keyFrames.empty());
    const auto isBefore = [](double time, const Key& key) { return time < key.seconds; };
    const auto next = std::upper_bound(keyFrames.begin(), keyFrames.end(), seconds, isBefore);
    if (next == keyFrames.begin()) return {*next, *next};
    const auto previous = next - 1;
    if (next == keyFrames.end() || previous->step) return {*previous, *previous};
    return {*previous, *next};
}

float calculateProgression(double previousSeconds, double nextSeconds, double seconds) {
    const double length = nextSeconds - previousSeconds;
    return length > 0.0 ? static_cast<float>((seconds - previousSeconds) / length) : 0.0f;
}

JointTransform interpolatePoses(const KeyFrame& previous, const KeyFrame& next, float progression) {
    if (&previous == &next) return previous.transform;
    return JointTransform::interpolate(previous.transform, next.transform, progression);
}

// The Java calls itself for each child joint and looks up its pose by name. Here parents come first in the array,
// so each joint finds its parent's transform already done. The last step, from a joint's transform to its matrix in
// the palette, belongs to the skin: computePalette in Skin.cpp.
void Animator::applyPoseToJoints() {
    const std::vector<Joint>& joints = skeleton_->joints;
    assert(joints.size() == modelTransforms_.size());
    for (std::size_t i = 0; i < modelTransforms_.size(); ++i) {
        // The document's axes and unit are converted here, above the roots, and nowhere else.
        const glm::mat4& parentTransform = joints[i].parent == kNoParent
                                               ? skeleton_->rootTransform
                                               : modelTransforms_[static_cast<std::size_t>(joints[i].parent)];
        modelTransforms_[i] = parentTransform * pose_.localTransform(i);
    }
}

// That was the episode. The rest is seeking, speed and loop modes.

void Animator::setTime(double seconds) {
    if (!animation_ || std::isnan(seconds)) return;
    animationTime_ = seconds;
    update(0.0);
}

void Animator::step(double seconds) {
    const bool goesBack = animationTime_ > lengthInSeconds();
    double there = time() + seconds;
    if (loopMode_ != LoopMode::Loop) there = std::clamp(there, 0.0, lengthInSeconds());
    setTime(goesBack ? 2.0 * lengthInSeconds() - there : there);
}

void Animator::sampleAt(double documentSeconds) {
    if (!animation_ || std::isnan(documentSeconds)) return;
    const double start = animation_->startSeconds;
    const double seconds = std::clamp(documentSeconds, start, std::max(start, animation_->endSeconds));
    animationTime_ = seconds - start;
    calculateCurrentAnimationPose(seconds);
    applyPoseToJoints();
}

void Animator::setSpeed(double speed) {
    if (std::isnan(speed)) return;
    const double size = std::abs(speed);
    speed_ = size == 0.0 ? 0.0 : std::copysign(std::clamp(size, kSlowest, kFastest), speed);
}

void Animator::setLoopMode(LoopMode mode) {
    animationTime_ = time();
    loopMode_ = mode;
}

double Animator::time() const {
    const double length = lengthInSeconds();
    return animationTime_ <= length ? animationTime_ : 2.0 * length - animationTime_;
}

bool Animator::atEnd() const {
    if (!animation_ || loopMode_ != LoopMode::Once) return false;
    return speed_ < 0.0 ? time() <= 0.0 : time() >= lengthInSeconds();
}

double Animator::lengthInSeconds() const {
    return animation_ ? std::max(0.0, animation_->lengthInSeconds()) : 0.0;
}

// At the clip's end this is endSeconds itself: start + length may round to less, and miss a key frame there.
double Animator::timeInDocument() const {
    const double seconds = time();
    if (seconds < lengthInSeconds()) return animation_->startSeconds + seconds;
    return std::max(animation_->startSeconds, animation_->endSeconds);
}

double loop(double seconds, double length) {
    if (!(length > 0.0) || !std::isfinite(seconds)) return 0.0;
    const double wrapped = seconds - length * std::floor(seconds / length);
    // Just below zero, `wrapped` rounds to the length itself, which is the start again.
    return wrapped >= 0.0 && wrapped < length ? wrapped : 0.0;
}

// The other kinds of key frames share the search for previous and next.
template PreviousAndNext<KeyFrame> getPreviousAndNextFrames(const std::vector<KeyFrame>&, double);
template PreviousAndNext<MatrixKeyFrame> getPreviousAndNextFrames(const std::vector<MatrixKeyFrame>&, double);
template PreviousAndNext<ParameterKeyFrame> getPreviousAndNextFrames(const std::vector<ParameterKeyFrame>&,
                                                                     double);

}  // namespace walkcycle
