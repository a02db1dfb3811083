#pragma once

#include <vector>

namespace walkcycle {

// A single number that moves: a morph weight, a light's intensity, a colour's red.
struct ParameterKeyFrame {
    double seconds = 0.0;
    float value = 0.0f;
    bool step = false;  // holds until the next key frame
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

// The number at a time of the document's timeline. The track must have key frames.
float sample(const ParameterTrack& track, double seconds);

}  // namespace walkcycle
