#include "animation/ExactChannel.h"

#include <algorithm>
#include <cmath>

#include "animation/ClipTimeline.h"

namespace walkcycle {
namespace {

double length(const glm::dquat& q) {
    return std::sqrt(glm::dot(q, q));
}

// Of unit length, and on a's side of the sphere.
glm::dquat nearest(const glm::dquat& a, const glm::quat& b) {
    const glm::dquat unit = glm::normalize(glm::dquat(b));
    return glm::dot(a, unit) < 0.0 ? -unit : unit;
}

double halfAngle(const glm::dquat& a, const glm::dquat& b) {
    return 2.0 * std::atan2(length(b - a), length(b + a));
}

glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double progression) {
    const double angle = halfAngle(a, b);
    if (angle < 1e-6) return glm::normalize(a * (1.0 - progression) + b * progression);
    return (a * std::sin((1.0 - progression) * angle) + b * std::sin(progression * angle)) / std::sin(angle);
}

// Hermite's cubic over a whole segment of the channel, cut down to the part from s to s + share of it.
ExactChannel::Cubic part(double a, double out, double b, double in, double seconds, double s, double share) {
    const double c1 = out * seconds, end = in * seconds;
    const double c2 = 3.0 * (b - a) - 2.0 * c1 - end, c3 = 2.0 * (a - b) + c1 + end;
    return {a + s * (c1 + s * (c2 + s * c3)), share * (c1 + s * (2.0 * c2 + s * 3.0 * c3)),
            share * share * (c2 + 3.0 * s * c3), share * share * share * c3};
}

}  // namespace

ExactChannel::ExactChannel(const Channel& channel) : channel_(&channel) {
    for (std::size_t k = 0; k < keyCount(); ++k) {
        const double begin = secondsOf(k);
        times_.push_back(begin);
        if (k + 1 == keyCount()) break;
        const double end = secondsOf(k + 1);
        if (isStep(k) || end == begin) {
            jumps_.push_back(end);
            continue;
        }
        if (isMatrix() || isCubic()) continue;
        const glm::dquat a = glm::normalize(glm::dquat(channel.keyFrames[k].transform.rotation));
        const double angle = halfAngle(a, nearest(a, channel.keyFrames[k + 1].transform.rotation));
        const int pieces = static_cast<int>(std::ceil(angle / ClipTimeline::kMaxTurn));
        for (int i = 1; i < pieces; ++i) times_.push_back(begin + (end - begin) * i / pieces);
    }
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
    jumps_.erase(std::unique(jumps_.begin(), jumps_.end()), jumps_.end());
}

std::size_t ExactChannel::keyCount() const {
    return isMatrix() ? channel_->matrixKeyFrames.size() : channel_->keyFrames.size();
}

double ExactChannel::secondsOf(std::size_t key) const {
    return isMatrix() ? channel_->matrixKeyFrames[key].seconds : channel_->keyFrames[key].seconds;
}

bool ExactChannel::isStep(std::size_t key) const {
    return isMatrix() ? channel_->matrixKeyFrames[key].step : channel_->keyFrames[key].step;
}

ExactChannel::Place ExactChannel::placeOf(double seconds, Side side) const {
    std::size_t low = 0, high = keyCount();  // the first key that is still to come
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        const double at = secondsOf(middle);
        if (at < seconds || (at == seconds && side == Side::Right))
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0) return {};
    if (low == keyCount() || isStep(low - 1)) return {low - 1, low - 1, 0.0};
    const double begin = secondsOf(low - 1);
    return {low - 1, low, (seconds - begin) / (secondsOf(low) - begin)};
}

ExactChannel::Transform ExactChannel::transformAt(double seconds, Side side) const {
    const Place at = placeOf(seconds, side);
    const JointTransform& from = channel_->keyFrames[at.key].transform;
    const JointTransform& to = channel_->keyFrames[at.next].transform;
    const glm::dquat rotation = glm::normalize(glm::dquat(from.rotation));
    return {glm::mix(glm::dvec3(from.position), glm::dvec3(to.position), at.progression),
            slerp(rotation, nearest(rotation, to.rotation), at.progression),
            glm::mix(glm::dvec3(from.scale), glm::dvec3(to.scale), at.progression)};
}

glm::dmat4 ExactChannel::matrixAt(double seconds, Side side) const {
    const Place at = placeOf(seconds, side);
    return glm::dmat4(channel_->matrixKeyFrames[at.key].matrix) * (1.0 - at.progression) +
           glm::dmat4(channel_->matrixKeyFrames[at.next].matrix) * at.progression;
}

ExactChannel::Cubics ExactChannel::cubicsBetween(double begin, double end) const {
    const Place at = placeOf(begin, Side::Right);
    const JointTransform &from = channel_->keyFrames[at.key].transform,
                         &to = channel_->keyFrames[at.next].transform;
    const KeyTangents::Rates &out = channel_->tangents[at.key].out, &in = channel_->tangents[at.next].in;
    const double seconds = secondsOf(at.next) - secondsOf(at.key);
    const double share = seconds > 0.0 ? (end - begin) / seconds : 0.0;
    Cubics cubics;
    const auto cut = [&](auto& into, const auto& a, const auto& leaving, const auto& b,
                         const auto& arriving) {
        for (int i = 0; i < static_cast<int>(into.size()); ++i)
            into[static_cast<std::size_t>(i)] =
                part(a[i], leaving[i], b[i], arriving[i], seconds, at.progression, share);
    };
    cut(cubics.rotation, from.rotation, out.rotation, to.rotation, in.rotation);
    cut(cubics.position, from.position, out.position, to.position, in.position);
    cut(cubics.scale, from.scale, out.scale, to.scale, in.scale);
    return cubics;
}

}  // namespace walkcycle
