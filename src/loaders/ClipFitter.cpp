#include "loaders/ClipFitter.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "loaders/KeyFrameFitter.h"

namespace walkcycle {

namespace {

// The keys from the last one at or before `start` to the first one at or after `end`.
template <typename Key>
std::pair<std::size_t, std::size_t> keptRange(const std::vector<Key>& keys, double start, double end) {
    const auto after = std::upper_bound(keys.begin(), keys.end(), start,
                                        [](double t, const Key& k) { return t < k.seconds; });
    auto until =
        std::lower_bound(keys.begin(), keys.end(), end, [](const Key& k, double t) { return k.seconds < t; });
    while (until != keys.end() && until + 1 != keys.end() && (until + 1)->seconds <= end) ++until;
    const auto first = after == keys.begin() ? 0 : after - keys.begin() - 1;
    const auto last = until == keys.end() ? until - keys.begin() : until - keys.begin() + 1;
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::max(last, first + 1))};
}

template <typename Key>
std::vector<Key> cut(const std::vector<Key>& keys, double start, double end) {
    if (keys.empty()) return {};
    const auto [first, last] = keptRange(keys, start, end);
    return {keys.begin() + static_cast<std::ptrdiff_t>(first),
            keys.begin() + static_cast<std::ptrdiff_t>(last)};
}

Channel cut(const Channel& channel, double start, double end) {
    Channel part{.joint = channel.joint};
    part.keyFrames = cut(channel.keyFrames, start, end);
    part.matrixKeyFrames = cut(channel.matrixKeyFrames, start, end);
    if (!channel.tangents.empty()) {
        const auto [first, last] = keptRange(channel.keyFrames, start, end);
        part.tangents.assign(channel.tangents.begin() + static_cast<std::ptrdiff_t>(first),
                             channel.tangents.begin() + static_cast<std::ptrdiff_t>(last));
    }
    return part;
}

// Index of the motion of the same joint among those of the whole timeline, if the same channels make it; their number if
// not.
std::size_t alike(const JointMotion& motion, const std::vector<JointMotion>& others) {
    const auto same =
        std::lower_bound(others.begin(), others.end(), motion.joint,
                         [](const JointMotion& other, int joint) { return other.joint < joint; });
    assert(same != others.end() && same->joint == motion.joint);  // a clip is a part of the whole
    return same->bindings.size() == motion.bindings.size() ? static_cast<std::size_t>(same - others.begin())
                                                           : others.size();
}

// What moves wildly takes keys that the file does not have: so many, of all motions together, are its due.
constexpr std::size_t kSpareKeys = 50'000;

// The keys of the file, as if they were text.
template <typename MotionOfOne>
double workOf(const MotionOfOne& moving) {
    constexpr double kPerKey = 64.0;
    double keys = 1.0;
    for (const auto& binding : moving.bindings) keys += static_cast<double>(binding.curve->times.size());
    return kPerKey * keys;
}

Animation emptyClip(std::string name, double start, double end) {
    Animation animation;
    animation.name = std::move(name);
    animation.startSeconds = start;
    animation.endSeconds = end;
    return animation;
}

}  // namespace

double workOf(const Motion& motion) {
    double work = 0.0;
    for (const JointMotion& joint : motion.joints) work += workOf<JointMotion>(joint);
    for (const ParameterMotion& moving : motion.parameters) work += workOf<ParameterMotion>(moving);
    return work;
}

ClipFitter::ClipFitter(const Model& model, const Motion& motion, const LoadContext& context, XmlNode collada)
    : model_(model),
      motion_(motion),
      context_(context),
      collada_(collada),
      reach_(model, motion, motion.start()),
      share_(0.8 * context.options.tolerance) {}

// Each joint may be off by its budget; how errors add up along the chains shows only when it is measured.
Animation ClipFitter::whole(std::string name) {
    Animation animation = emptyClip(std::move(name), motion_.start(), motion_.end());
    constexpr int kTries = 4;
    for (int i = 0; i < kTries; ++i) {
        const std::uint64_t keysBefore = std::exchange(keys_, 0);
        fit(motion_, nullptr, animation);
        const double error = animation.achievedError;
        if (error <= context_.options.tolerance) return animation;
        if (spare_ == 0 || keys_ < keysBefore + keysBefore / 8)
            break;  // asking for more precision gives no more keys
        share_ *= std::clamp(0.7 * context_.options.tolerance / error, 0.05, 0.9);
    }
    context_.diagnostics.report(Code::ToleranceMissed, collada_.child("library_animations"),
                                {animation.name, std::to_string(animation.achievedError)});
    return animation;
}

Animation ClipFitter::clip(std::string name, double start, double end, const Motion& motion,
                           const Animation& whole) {
    Animation animation = emptyClip(std::move(name), start, end);
    fit(motion, &whole, animation);
    return animation;
}

void ClipFitter::fit(const Motion& motion, const Animation* whole, Animation& animation) {
    const double start = animation.startSeconds, end = animation.endSeconds;
    // One more than allowed, to tell a channel that needs as many from one that needs more.
    const std::size_t limit = std::min<std::uint64_t>(context_.options.limits.maxKeyFrames, 1u << 30) + 1;
    spare_ = kSpareKeys;
    const auto spend = [&](std::size_t keys, std::size_t knots) {
        spare_ -= std::min(spare_, keys - std::min(keys, knots));
        count(keys);
    };
    bool isOfWhole = whole && motion.parameters.empty();  // every key has been measured already
    animation.channels.clear();
    animation.parameterTracks.clear();
    if (whole)
        count(8 * motion.joints.size());  // a clip's channels take memory of their own beside their keys
    for (const JointMotion& joint : motion.joints) {
        context_.checkCancelled(collada_);
        const std::size_t same = whole ? alike(joint, motion_.joints) : motion_.joints.size();
        isOfWhole = isOfWhole && same < motion_.joints.size();
        const std::vector<double> knots = joint.knots(start, end, limit);
        if (same < motion_.joints.size())
            animation.channels.push_back(cut(whole->channels[same], start, end));
        else
            animation.channels.push_back(
                fitChannel(joint, knots, reach_.tolerance(joint.joint, share_), limit, spare_));
        const Channel& made = animation.channels.back();
        spend(made.keyFrames.size() + made.matrixKeyFrames.size(), knots.size());
        context_.advance(workOf(joint));
    }
    for (const ParameterMotion& moving : motion.parameters) {
        const Parameter& parameter = model_.parameters[static_cast<std::size_t>(moving.parameter)];
        const Tolerance tolerance = reach_.tolerance(parameter, model_, context_.options.tolerance);
        const std::vector<double> knots = moving.knots(start, end, limit);
        animation.parameterTracks.push_back(fitTrack(moving, knots, tolerance, limit, spare_));
        spend(animation.parameterTracks.back().keyFrames.size(), knots.size());
        context_.advance(workOf(moving));
    }
    animation.achievedError =
        isOfWhole ? whole->achievedError : static_cast<float>(reach_.measure(model_, motion, animation));
}

void ClipFitter::count(std::size_t keys) {
    keys_ += keys;
    context_.require(keys_, &LoadLimits::maxKeyFrames, collada_);
}

}  // namespace walkcycle
