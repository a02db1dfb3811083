#pragma once

#include <string>
#include <vector>

#include <walkcycle/animation/KeyFrame.h>

namespace walkcycle {

// The motion of one joint: key frames sorted by time. Two key frames at the same time make a jump: the first is the
// value just before that time, the second the value from it on. One of keyFrames and matrixKeyFrames is empty.
struct Channel {
    int joint = 0;  // index into Skeleton::joints
    std::vector<KeyFrame> keyFrames{};
    std::vector<MatrixKeyFrame> matrixKeyFrames{};
    // One per entry of keyFrames, or empty. With tangents, each number follows a cubic curve between the key frames:
    // smooth motion needs far fewer of them. Without, position and scale are blended linearly, rotation by slerp.
    std::vector<KeyTangents> tangents{};
};

// The motion of one number of the model that is not part of a joint's transform: a morph weight, a light's intensity.
struct ParameterTrack {
    int parameter = 0;  // index into Model::parameters
    std::vector<ParameterKeyFrame> keyFrames{};
    // How fast the value changes, per second: as the curve arrives at a key frame (`in`) and as it leaves it (`out`).
    struct Tangents {
        float in = 0.0f, out = 0.0f;
    };
    std::vector<Tangents> tangents{};  // one per key frame, or empty: then linear
};

// A clip: everything that moves between startSeconds and endSeconds of the document's timeline. All key frames carry
// times of that timeline.
struct Animation {
    std::string name;
    double startSeconds = 0.0;
    double endSeconds = 0.0;
    std::vector<Channel> channels;
    std::vector<ParameterTrack> parameterTracks;
    float achievedError = 0.0f;  // largest distance between these keys and the file's own curves, as a share
                                 // of the model's size

    // 0 for a clip of a single pose.
    double lengthInSeconds() const { return endSeconds - startSeconds; }
};

}  // namespace walkcycle
