#pragma once

#include <span>
#include <vector>

#include <walkcycle/Export.h>
#include <walkcycle/animation/Animation.h>
#include <walkcycle/animation/Pose.h>

namespace walkcycle {

// How a clip goes on at its end.
enum class LoopMode {
    Once,     // stays there
    Loop,     // starts again
    PingPong  // plays back to its start, then forwards again
};

// Plays an Animation on a Skeleton, as the series' Animator does: each update() increases the clip's time, blends
// the key frames around that time into a pose, and computes one transform per joint from the pose. The Java makes maps of
// names for each frame; this walks arrays and reuses their memory. Keeps pointers to the skeleton and the animation,
// which must outlive it. Times that are NaN
// are ignored.
class WALKCYCLE_API Animator {
public:
    // Holds the rest pose until doAnimation(). `restParameters` are the values of Model::parameters at rest; may be empty.
    explicit Animator(const Skeleton& skeleton, std::span<const float> restParameters = {});
    explicit Animator(const Skeleton&& temporary, std::span<const float> restParameters = {}) = delete;

    // Starts a clip: at its start, or at its end if it plays once and backwards.
    void doAnimation(const Animation& animation);
    void doAnimation(const Animation&& temporary) = delete;

    // Plays on for `seconds` (negative: backwards), times the speed.
    void update(double seconds);

    // Seeks to the time that the clip has after playing for `seconds` from its start: `seconds` itself within the
    // clip's length; beyond it, the loop mode decides.
    void setTime(double seconds);

    // Moves to a later (negative: an earlier) time of the clip, whatever the speed and the direction of playing.
    // Stops at the clip's ends, unless it loops.
    void step(double seconds);

    // Seeks to a time of the document's timeline. Ignores the loop mode: before the clip's start this gives its first
    // pose, after its end its last.
    void sampleAt(double documentSeconds);

    static constexpr double kSlowest = 1.0 / 128.0, kFastest = 128.0;  // the bounds of setSpeed()

    // A factor: 1 is the clip's own speed, 0 stands still, negative plays backwards. Unless it is 0, its absolute value
    // is clamped to kSlowest and kFastest. NaN is ignored.
    void setSpeed(double speed);
    double speed() const { return speed_; }

    void setLoopMode(LoopMode mode);  // keeps the time
    LoopMode loopMode() const { return loopMode_; }

    double time() const;  // seconds since the clip's start: 0 to its length
    bool atEnd() const;   // the clip plays once and has ended: update() changes nothing any more
    const Animation* animation() const { return animation_; }  // null before doAnimation()

    // The current pose, its matrices from joint space to model space (one per joint), and the current values of
    // Model::parameters. Before doAnimation() all are at rest.
    const Pose& pose() const { return pose_; }
    const std::vector<glm::mat4>& modelTransforms() const { return modelTransforms_; }
    const std::vector<float>& parameters() const { return parameters_; }

private:
    void increaseAnimationTime(double seconds);
    void calculateCurrentAnimationPose(double documentSeconds);
    void applyPoseToJoints();
    double lengthInSeconds() const;
    double timeInDocument() const;

    const Skeleton* skeleton_;
    const Animation* animation_ = nullptr;
    LoopMode loopMode_ = LoopMode::Loop;
    double speed_ = 1.0;
    double animationTime_ = 0.0;  // 0 to the clip's length; up to twice that while PingPong plays back
    Pose restPose_, pose_;
    std::vector<float> restParameters_, parameters_;
    std::vector<glm::mat4> modelTransforms_;  // joint space -> model space, per joint
};

// The channel's transform at a time of the document's timeline: before its first key frame the first holds, after its
// last the last. channel.keyFrames must not be empty.
WALKCYCLE_API JointTransform sample(const Channel& channel, double seconds);

// Wraps `seconds` into [0, length). Returns 0 if the length is 0 (a clip of a single pose) or `seconds` is not finite.
WALKCYCLE_API double loop(double seconds, double length);

}  // namespace walkcycle
