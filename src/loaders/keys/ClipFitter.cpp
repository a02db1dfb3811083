#include "loaders/keys/ClipFitter.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "loaders/keys/KeyFrameFitter.h"

namespace walkcycle {

namespace {

// The indices [first, last) of the keys from the last one at or before `start` to the first one at or after
// `end`.
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

// The keys of a clip, copied from those of the whole timeline.
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

// Whether the same channels of the file move a joint in the clip and over the whole timeline.
bool isAlike(const JointMotion& motion, const JointMotion& whole) {
    return motion.bindings.size() == whole.bindings.size();
}

// Index of the joint's motion over the whole timeline. A clip is a part of it, so there is one.
std::size_t indexOf(int joint, const std::vector<JointMotion>& motions) {
    const auto found = std::lower_bound(motions.begin(), motions.end(), joint,
                                        [](const JointMotion& motion, int j) { return motion.joint < j; });
    assert(found != motions.end() && found->joint == joint);
    return static_cast<std::size_t>(found - motions.begin());
}

// The work of fitting one motion (see LoadProgress): each key of the file counts like so many bytes of text.
template <typename MotionOfOne>
double workOf(const MotionOfOne& moving) {
    constexpr double kPerKey = 64.0;
    double keys = 1.0;
    for (const auto& binding : moving.bindings) keys += static_cast<double>(binding.curve->times.size());
    return kPerKey * keys;
}

constexpr std::size_t kSpareKeys = 50'000;  // of all motions of a clip together

constexpr double kDefaultTolerance = 1e-4;
constexpr int kCoarsest = -8, kFinest = 12;

double toleranceOf(int level) {
    return kDefaultTolerance * std::pow(10.0, -0.5 * level);
}

// The coarsest level whose tolerance is not larger.
int levelOf(double tolerance) {
    if (!(tolerance > 0.0)) return kFinest;
    const double level = std::ceil(-2.0 * std::log10(tolerance / kDefaultTolerance) - 1e-6);
    return static_cast<int>(std::clamp<double>(level, kCoarsest, kFinest));
}

bool areWithin(const std::vector<Animation>& animations, double tolerance) {
    return std::all_of(animations.begin(), animations.end(),
                       [&](const Animation& animation) { return animation.achievedError <= tolerance; });
}

std::string scientific(float value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr};
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
      reach_(model, motion, motion.start()) {}

std::vector<Animation> ClipFitter::fit(const std::string& name, const std::vector<ClipRange>& clips) {
    const double tolerance = context_.options.tolerance;
    const int level = levelOf(tolerance);
    std::vector<Animation> animations =
        refine({name, clips}, std::max(level, 0), std::min(tolerance, kDefaultTolerance));
    if (level < 0) coarsen({name, clips}, level, animations);
    if (animations.empty()) context_.require(keys_, &LoadLimits::maxKeyFrames, collada_);
    for (const Animation& animation : animations)
        if (animation.achievedError > tolerance)
            context_.diagnostics.report(Code::ToleranceMissed, collada_.child("library_animations"),
                                        {animation.name, scientific(animation.achievedError)});
    return animations;
}

// Each joint may be off by its budget. How the errors add up along the chains is known only after measuring,
// so a finer level than the requested one may be needed. Keeps for each clip the level with the smallest
// error.
std::vector<Animation> ClipFitter::refine(const Source& source, int level, double tolerance) {
    constexpr int kMoreLevels = 3;
    std::vector<Animation> best;
    std::uint64_t keysBefore = 0;
    for (int i = 0; i <= level + kMoreLevels; ++i) {
        std::vector<Animation> animations = fitLevel(source, i);
        if (keys_ > context_.options.limits.maxKeyFrames) break;
        if (best.empty()) best = animations;
        for (std::size_t clip = 0; clip < best.size(); ++clip)
            if (animations[clip].achievedError < best[clip].achievedError)
                best[clip] = std::move(animations[clip]);
        const bool hasMoreKeys = keys_ > keysBefore + keysBefore / 8;
        if (i >= level && (areWithin(best, tolerance) || (i > level && !hasMoreKeys))) break;
        if (ranOut_ || 0.8 * toleranceOf(i) < reach_.finestShare()) break;
        keysBefore = keys_;
    }
    return best;
}

// Coarser levels have fewer keys. A coarser level is not used for a clip if its error happens to be smaller,
// too, or if it exceeds the tolerance of the level.
void ClipFitter::coarsen(const Source& source, int level, std::vector<Animation>& animations) {
    for (int i = -1; i >= level; --i) {
        std::vector<Animation> coarser = fitLevel(source, i);
        if (keys_ > context_.options.limits.maxKeyFrames) continue;
        if (animations.empty()) animations = coarser;
        for (std::size_t clip = 0; clip < animations.size(); ++clip) {
            const float error = coarser[clip].achievedError;
            if (error >= animations[clip].achievedError && error <= toleranceOf(i))
                animations[clip] = std::move(coarser[clip]);
        }
    }
}

// Fits all clips with the tolerance of one level. Stops when there are more keys than
// LoadLimits::maxKeyFrames.
std::vector<Animation> ClipFitter::fitLevel(const Source& source, int level) {
    keys_ = 0;
    ranOut_ = false;
    std::vector<Animation> animations(1);
    animations[0].name = source.name;
    animations[0].startSeconds = motion_.start();
    animations[0].endSeconds = motion_.end();
    fitClip(motion_, nullptr, level, animations[0]);
    for (const ClipRange& clip : source.clips) {
        const Motion part = motion_.restricted([&](int channel) { return clip.plays(channel); });
        if (part.joints.empty() && part.parameters.empty()) continue;
        Animation animation;
        animation.name = clip.name;
        animation.startSeconds = clip.start;
        animation.endSeconds = std::max(clip.start, clip.end.value_or(part.end()));
        fitClip(part, &animations[0], level, animation);
        animations.push_back(std::move(animation));
    }
    return animations;
}

// Fits one clip. If the spare keys run out, the first motions have used them up. Then the clip is fitted
// again with the same number for each motion.
void ClipFitter::fitClip(const Motion& motion, const Animation* whole, int level, Animation& animation) {
    const std::uint64_t keysBefore = keys_;
    spareKeysEach_ = spareKeys_ = kSpareKeys;
    fitMotions(motion, whole, level, animation);
    if (spareKeys_ > 0) return;
    ranOut_ = true;
    keys_ = keysBefore;
    spareKeysEach_ = kSpareKeys / (motion.joints.size() + motion.parameters.size());
    spareKeys_ = SIZE_MAX;
    fitMotions(motion, whole, level, animation);
}

// Fits the motions of one clip. A joint that the same channels move in the clip and in `whole`, the whole
// timeline, gets a copy of its keys there. `whole` is null if this is the whole timeline.
void ClipFitter::fitMotions(const Motion& motion, const Animation* whole, int level, Animation& animation) {
    const double start = animation.startSeconds, end = animation.endSeconds;
    const std::size_t limit = keyLimits().most;
    bool isMeasured = whole && motion.parameters.empty();
    animation.channels.clear();
    animation.parameterTracks.clear();
    if (whole)
        keys_ += 8 * motion.joints.size();  // the channels of a clip take as much memory as so many keys
    for (const JointMotion& joint : motion.joints) {
        context_.checkCancelled(collada_);
        if (spareKeys_ == 0 || keys_ > context_.options.limits.maxKeyFrames) return;
        const std::size_t index = whole ? indexOf(joint.joint, motion_.joints) : 0;
        if (whole && isAlike(joint, motion_.joints[index])) {
            animation.channels.push_back(cut(whole->channels[index], start, end));
            const Channel& part = animation.channels.back();
            keys_ += part.keyFrames.size() + part.matrixKeyFrames.size();
            continue;
        }
        isMeasured = false;
        const Tolerance tolerance = reach_.tolerance(joint.joint, 0.8 * toleranceOf(level));
        const std::vector<double> knots = joint.knots(start, end, limit);
        animation.channels.push_back(fitChannel(joint, knots, tolerance, keyLimits()));
        const Channel& made = animation.channels.back();
        count(made.keyFrames.size() + made.matrixKeyFrames.size(), knots.size());
        context_.advance(workOf(joint));
    }
    for (const ParameterMotion& moving : motion.parameters) {
        if (spareKeys_ == 0 || keys_ > context_.options.limits.maxKeyFrames) return;
        const Parameter& parameter = model_.parameters[static_cast<std::size_t>(moving.parameter)];
        const Tolerance tolerance = reach_.tolerance(parameter, model_, toleranceOf(level));
        const std::vector<double> knots = moving.knots(start, end, limit);
        animation.parameterTracks.push_back(fitTrack(moving, knots, tolerance, keyLimits()));
        count(animation.parameterTracks.back().keyFrames.size(), knots.size());
        context_.advance(workOf(moving));
    }
    animation.achievedError =
        isMeasured ? whole->achievedError : static_cast<float>(reach_.measure(model_, motion, animation));
}

// One key more than allowed: a channel that needs exactly the allowed number must differ from one that needs
// more.
KeyLimits ClipFitter::keyLimits() const {
    const std::uint64_t most = std::min<std::uint64_t>(context_.options.limits.maxKeyFrames, 1u << 30);
    return {static_cast<std::size_t>(most + 1), std::min(spareKeys_, spareKeysEach_)};
}

void ClipFitter::count(std::size_t keys, std::size_t knots) {
    keys_ += keys;
    spareKeys_ -= std::min(spareKeys_, keys - std::min(keys, knots));
}

}  // namespace walkcycle
