#include "crowd/ExactChannel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "animation/Interpolation.h"
#include "crowd/ClipTimeline.h"

namespace walkcycle {
namespace {

double halfAngle(const JointTransform& a, const JointTransform& b) {
    return std::acos(std::min(1.0, std::abs(glm::dot(glm::dquat(a.rotation), glm::dquat(b.rotation)))));
}

// The ten numbers of a transform, or of its tangent, in the order of Cubics.
template <typename Transform>
std::array<double, 10> numbersOf(const Transform& t) {
    return {t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w, t.position.x,
            t.position.y, t.position.z, t.scale.x,    t.scale.y,    t.scale.z};
}

// The part of a curve from s to s + share, as a curve from 0 to 1.
ExactChannel::Cubic part(const ExactChannel::Cubic& c, double s, double share) {
    return {c[0] + s * (c[1] + s * (c[2] + s * c[3])), share * (c[1] + s * (2.0 * c[2] + s * 3.0 * c[3])),
            share * share * (c[2] + 3.0 * s * c[3]), share * share * share * c[3]};
}

}  // namespace

ExactChannel::ExactChannel(const Channel& channel) : channel_(&channel) {
    for (const KeyFrame& key : channel.keyFrames) keys_.push_back({key.seconds, key.step});
    if (isMatrix())
        for (const MatrixKeyFrame& key : channel.matrixKeyFrames) keys_.push_back({key.seconds, key.step});
    for (std::size_t k = 0; k < keys_.size(); ++k) {
        const double begin = keys_[k].seconds;
        times_.push_back(begin);
        if (k + 1 == keys_.size()) break;
        const double end = keys_[k + 1].seconds;
        if (keys_[k].step || end == begin) {
            jumps_.push_back(end);
            continue;
        }
        if (isMatrix() || isCubic()) continue;
        const double angle = halfAngle(channel.keyFrames[k].transform, channel.keyFrames[k + 1].transform);
        const int pieces = static_cast<int>(std::ceil(angle / ClipTimeline::kMaxHalfAngle));
        for (int i = 1; i < pieces; ++i) times_.push_back(begin + (end - begin) * i / pieces);
    }
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
    jumps_.erase(std::unique(jumps_.begin(), jumps_.end()), jumps_.end());
}

ExactChannel::Between ExactChannel::keysAround(double seconds, Side side) const {
    const auto hasCome = [&](const Key& key) {
        return key.seconds < seconds || (key.seconds == seconds && side == Side::Right);
    };
    const auto next = std::partition_point(keys_.begin(), keys_.end(), hasCome);
    if (next == keys_.begin()) return {};
    const auto to = static_cast<std::size_t>(next - keys_.begin());
    const Key& key = keys_[to - 1];
    if (next == keys_.end() || key.step) return {to - 1, to - 1, 0.0};
    return {to - 1, to, (seconds - key.seconds) / (next->seconds - key.seconds)};
}

ExactTransform ExactChannel::transformAt(double seconds, Side side) const {
    const Between at = keysAround(seconds, side);
    return ExactTransform::interpolate(ExactTransform(channel_->keyFrames[at.from].transform),
                                       ExactTransform(channel_->keyFrames[at.to].transform), at.progression);
}

glm::dmat4 ExactChannel::matrixAt(double seconds, Side side) const {
    const Between at = keysAround(seconds, side);
    return glm::dmat4(channel_->matrixKeyFrames[at.from].matrix) * (1.0 - at.progression) +
           glm::dmat4(channel_->matrixKeyFrames[at.to].matrix) * at.progression;
}

ExactChannel::Cubics ExactChannel::cubicsBetween(double begin, double end) const {
    const Between at = keysAround(begin, Side::Right);
    const auto a = numbersOf(channel_->keyFrames[at.from].transform),
               leaving = numbersOf(channel_->tangents[at.from].out);
    const auto b = numbersOf(channel_->keyFrames[at.to].transform),
               arriving = numbersOf(channel_->tangents[at.to].in);
    const double seconds = keys_[at.to].seconds - keys_[at.from].seconds;
    const double share = seconds > 0.0 ? (end - begin) / seconds : 0.0;
    Cubics cubics;
    for (std::size_t i = 0; i < cubics.size(); ++i)
        cubics[i] = part(hermitePowers(a[i], leaving[i] * seconds, b[i], arriving[i] * seconds),
                         at.progression, share);
    return cubics;
}

}  // namespace walkcycle
