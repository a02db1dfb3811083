#pragma once

#include <string>
#include <vector>

#include <walkcycle/animation/KeyFrame.h>

namespace walkcycle {

// The motion of one joint: key frames in rising time. Two at one time are a jump (the first is its left side).
// Exactly one of keyFrames and matrixKeyFrames is in use.
struct Channel {
    int joint = 0;  // index into Skeleton::joints
    std::vector<KeyFrame> keyFrames{};
    std::vector<MatrixKeyFrame> matrixKeyFrames{};
    // One per entry of keyFrames, or none. With tangents the way between key frames is a cubic curve, which needs far
    // fewer key frames for smooth motion; without, a straight line and a slerp.
    std::vector<KeyTangents> tangents{};
};

// The motion of one number of the model that is not a joint's transform.
struct ParameterTrack {
    int parameter = 0;  // index into Model::parameters
    std::vector<ParameterKeyFrame> keyFrames{};
    // One per key frame, or none, as in a Channel: change per second as the curve arrives and leaves.
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

}  // namespace walkcycle
