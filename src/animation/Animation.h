#pragma once

#include <span>
#include <string>
#include <vector>

#include "animation/CurvedTransform.h"
#include "animation/KeyFrame.h"
#include "animation/Pose.h"

namespace walkcycle {

// How the curve of a key's numbers comes and goes: change per second on either side of it.
struct KeyTangents {
    using Rates = TransformRates<float>;
    Rates in, out;
};

// The motion of one joint: keys in rising time. Two keys at one time are a jump (the first is its left side).
// Exactly one of the two lists is in use.
struct Channel {
    int joint = 0;  // index into Skeleton::joints
    std::vector<KeyFrame> keyFrames{};
    std::vector<MatrixKeyFrame> matrixKeyFrames{};
    // One per entry of keyFrames, or none. With them each number runs on a cubic curve from key to key (glTF's
    // CUBICSPLINE), which smooth motion needs far fewer keys for; without, on straight lines and slerps.
    std::vector<KeyTangents> tangents{};
};

// The motion of one number of the model that is not a joint's transform.
struct ParameterTrack {
    int parameter = 0;  // index into Model::parameters
    std::vector<ParameterKeyFrame> keyFrames{};
    // One per key, or none, as of a Channel: change per second on either side.
    struct Tangents {
        float in = 0.0f, out = 0.0f;
    };
    std::vector<Tangents> tangents{};
};

// A clip: everything that moves between startSeconds and endSeconds of the document's timeline.
struct Animation {
    std::string name;
    double startSeconds = 0.0;
    double endSeconds = 0.0;
    std::vector<Channel> channels;
    std::vector<ParameterTrack> parameterTracks;
    float achievedError = 0.0f;  // largest distance between these keys and the file's own curves, as a share
                                 // of the model's size

    double lengthInSeconds() const { return endSeconds - startSeconds; }
};

// The channel's transform at a time of the document's timeline. Before the first key the first one holds,
// after the last the last one. The channel must have keys of that kind.
JointTransform sample(const Channel& channel, double seconds);
glm::mat4 sampleMatrix(const Channel& channel, double seconds);
float sample(const ParameterTrack& track, double seconds);

// Writes every channel of the clip into `pose`, and every parameter track into `parameters` (indexed as
// Model::parameters); what the clip does not move is left alone. Allocates nothing.
void sample(const Animation& animation, double seconds, Pose& pose, std::span<float> parameters);

}  // namespace walkcycle
