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

// Where two keys share a time, the search passes both: at that very time the later one counts.
template <class Key>
auto sampleKeys(const std::vector<Key>& keys, double seconds) {
    assert(!keys.empty());
    const auto isBefore = [](double time, const Key& key) { return time < key.seconds; };
    const auto next = std::upper_bound(keys.begin(), keys.end(), seconds, isBefore);
    if (next == keys.begin()) return valueOf(*next);
    const auto previous = next - 1;
    if (next == keys.end() || previous->step) return valueOf(*previous);
    const double progression = (seconds - previous->seconds) / (next->seconds - previous->seconds);
    return blend(valueOf(*previous), valueOf(*next), static_cast<float>(progression));
}

}  // namespace

JointTransform interpolateCurved(const JointTransform& a, const KeyTangents::Rates& leaving, const JointTransform& b,
                                 const KeyTangents::Rates& arriving, float seconds, float progression) {
    const float s = progression, s2 = s * s, s3 = s2 * s;
    const float fromB = 3.0f * s2 - 2.0f * s3, fromA = 1.0f - fromB;
    const float fromLeaving = (s3 - 2.0f * s2 + s) * seconds, fromArriving = (s3 - s2) * seconds;
    const auto cubic = [&](const auto& start, const auto& out, const auto& end, const auto& in) {
        return start * fromA + out * fromLeaving + end * fromB + in * fromArriving;
    };
    return {cubic(a.position, leaving.position, b.position, arriving.position),
            glm::normalize(cubic(a.rotation, leaving.rotation, b.rotation, arriving.rotation)),
            cubic(a.scale, leaving.scale, b.scale, arriving.scale)};
}

JointTransform sample(const Channel& channel, double seconds) {
    const std::vector<KeyFrame>& keys = channel.keyFrames;
    if (channel.tangents.empty()) return sampleKeys(keys, seconds);
    const auto isBefore = [](double time, const KeyFrame& key) { return time < key.seconds; };
    const auto next = std::upper_bound(keys.begin(), keys.end(), seconds, isBefore);
    if (next == keys.begin()) return next->transform;
    if (next == keys.end() || (next - 1)->step) return (next - 1)->transform;
    const auto i = static_cast<std::size_t>(next - keys.begin());
    const double length = keys[i].seconds - keys[i - 1].seconds;
    return interpolateCurved(keys[i - 1].transform, channel.tangents[i - 1].out, keys[i].transform,
                             channel.tangents[i].in, static_cast<float>(length),
                             static_cast<float>((seconds - keys[i - 1].seconds) / length));
}

glm::mat4 sampleMatrix(const Channel& channel, double seconds) {
    return sampleKeys(channel.matrixKeyFrames, seconds);
}

float sample(const ParameterTrack& track, double seconds) {
    return sampleKeys(track.keyFrames, seconds);
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
