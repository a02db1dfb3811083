#include "animation/Animation.h"

#include <algorithm>
#include <cassert>

namespace walkcycle {
namespace {

const JointTransform& valueOf(const KeyFrame& key) {
    return key.transform;
}
const glm::mat4& valueOf(const MatrixKeyFrame& key) {
    return key.matrix;
}
float valueOf(const ParameterKeyFrame& key) {
    return key.value;
}

JointTransform blend(const JointTransform& a, const JointTransform& b, float progression) {
    return JointTransform::interpolate(a, b, progression);
}
glm::mat4 blend(const glm::mat4& a, const glm::mat4& b, float progression) {
    return a * (1.0f - progression) + b * progression;
}
float blend(float a, float b, float progression) {
    return a + (b - a) * progression;
}

// The keys around a time; the same one twice where it holds.
struct Between {
    std::size_t from = 0, to = 0;
    float seconds = 0.0f;      // from one to the other
    float progression = 0.0f;  // 0 at the one, 1 at the other
};

// Where two keys share a time, the search passes both: at that very time the later one counts.
template <class Key>
Between keysAround(const std::vector<Key>& keys, double seconds) {
    assert(!keys.empty());
    const auto isBefore = [](double time, const Key& key) { return time < key.seconds; };
    const auto next = std::upper_bound(keys.begin(), keys.end(), seconds, isBefore);
    if (next == keys.begin()) return {};
    const auto to = static_cast<std::size_t>(next - keys.begin());
    if (next == keys.end() || keys[to - 1].step) return {to - 1, to - 1, 0.0f, 0.0f};
    const double length = keys[to].seconds - keys[to - 1].seconds;
    return {to - 1, to, static_cast<float>(length),
            static_cast<float>((seconds - keys[to - 1].seconds) / length)};
}

template <class Key>
auto sampleKeys(const std::vector<Key>& keys, double seconds) {
    const Between at = keysAround(keys, seconds);
    if (at.from == at.to) return valueOf(keys[at.from]);
    return blend(valueOf(keys[at.from]), valueOf(keys[at.to]), at.progression);
}

}  // namespace

JointTransform sample(const Channel& channel, double seconds) {
    const std::vector<KeyFrame>& keys = channel.keyFrames;
    if (channel.tangents.empty()) return sampleKeys(keys, seconds);
    const Between at = keysAround(keys, seconds);
    if (at.from == at.to) return keys[at.from].transform;
    return curvedTransform(keys[at.from].transform, channel.tangents[at.from].out, keys[at.to].transform,
                           channel.tangents[at.to].in, Hermite(at.progression, at.seconds));
}

glm::mat4 sampleMatrix(const Channel& channel, double seconds) {
    return sampleKeys(channel.matrixKeyFrames, seconds);
}

float sample(const ParameterTrack& track, double seconds) {
    const std::vector<ParameterKeyFrame>& keys = track.keyFrames;
    if (track.tangents.empty()) return sampleKeys(keys, seconds);
    const Between at = keysAround(keys, seconds);
    if (at.from == at.to) return keys[at.from].value;
    return Hermite(at.progression, at.seconds)
        .value(keys[at.from].value, track.tangents[at.from].out, keys[at.to].value, track.tangents[at.to].in);
}

void sample(const Animation& animation, double seconds, Pose& pose, std::span<float> parameters) {
    for (const Channel& channel : animation.channels) {
        const auto joint = static_cast<std::size_t>(channel.joint);
        assert(joint < pose.size());
        if (!channel.keyFrames.empty()) {
            pose.set(joint, sample(channel, seconds));
        } else if (!channel.matrixKeyFrames.empty()) {
            pose.set(joint, sampleMatrix(channel, seconds));
        }
    }
    for (const ParameterTrack& track : animation.parameterTracks) {
        const auto parameter = static_cast<std::size_t>(track.parameter);
        if (parameter < parameters.size() && !track.keyFrames.empty())
            parameters[parameter] = sample(track, seconds);
    }
}

}  // namespace walkcycle
