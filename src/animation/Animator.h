#pragma once

#include <span>
#include <vector>

#include "animation/Animation.h"
#include "animation/Pose.h"

namespace walkcycle {

// Plays an Animation on a Skeleton: keeps the clip's time, samples its keys, and turns the local transforms
// of the pose into model-space ones. (The series' Animator. Where the Java returns a map of names per frame,
// this walks arrays and reuses their memory.) Both skeleton and animation must outlive it.
class Animator {
public:
    // `restParameters` are the values of Model::parameters at rest; may be empty.
    explicit Animator(const Skeleton& skeleton, std::span<const float> restParameters = {});

    // Starts a clip at its beginning.
    void doAnimation(const Animation& animation);

    // Lets `seconds` go by (negative: backwards); playback wraps around the clip's ends.
    void update(double seconds);

    // Seeks to a time within the clip, 0 being its start; wraps likewise.
    void setTime(double seconds);

    // Poses the skeleton as it is at a time of the document's timeline, which is not wrapped: before and
    // after the clip its first and last poses hold.
    void sampleAt(double documentSeconds);

    double time() const { return time_; }  // seconds since the clip's start
    const Animation* animation() const { return animation_; }
    const Pose& pose() const { return pose_; }
    const std::vector<glm::mat4>& modelTransforms() const { return modelTransforms_; }
    const std::vector<float>& parameters() const { return parameters_; }

private:
    void rest();

    const Skeleton* skeleton_;
    const Animation* animation_ = nullptr;
    double time_ = 0.0;
    Pose restPose_, pose_;
    std::vector<float> restParameters_, parameters_;
    std::vector<glm::mat4> modelTransforms_;
};

// Playback wraps: the time within [0, length). A clip of a single pose has no length and stays at its start.
double loop(double seconds, double length);

}  // namespace walkcycle
