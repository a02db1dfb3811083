#include "loaders/keys/KeyFrameFitter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "loaders/keys/DecomposedMotion.h"
#include "loaders/keys/RunFitter.h"

namespace walkcycle {

namespace {

// Splits the knots into runs at the jumps of the motion. If it jumps at the last knot, the last run has only
// that time.
template <typename MotionOfOne, typename Jumps>
std::vector<Run> runsOf(const MotionOfOne& motion, const std::vector<double>& knots, const Jumps& jumps) {
    std::vector<Run> runs(1);
    const bool mayJump = motion.mayJump();
    bool isStill = true;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        runs.back().knots.push_back(knots[i]);
        if (!mayJump || i == 0) continue;
        isStill = isStill && motion.holds(knots[i - 1], knots[i]);
        if (!jumps(knots[i])) continue;
        runs.back().isStep = isStill;
        runs.push_back({{knots[i]}, false});
        isStill = true;
    }
    return runs;
}

// The most keys that a motion may get. A few more than in the file are always allowed. Beyond that it takes
// spare keys, whose number is limited: a joint that rotates a thousand times between two keys must not cost
// more than the file is worth. WC0513 reports the remaining error.
std::size_t mostKeys(std::size_t knots, const KeyLimits& limits) {
    return std::min(limits.most, 2 * knots + 32 + std::min(limits.spareKeys, 4096 + 64 * knots));
}

// Adds knots to long rotations: seen from its ends, a rotation by more than half a circle looks like a
// shorter one in the other direction. At most `spare` knots are added, evenly spread over the degrees of the
// motion.
class RotationSplitter {
public:
    // `degrees` as from JointMotion::degreesRotated.
    RotationSplitter(const std::vector<double>& degrees, std::size_t spare) : degrees_(degrees) {
        if (degrees.empty()) return;
        const double all = std::accumulate(degrees.begin(), degrees.end(), 0.0);
        if (all > 0.0) degreesPerKey_ = std::max(60.0, all / static_cast<double>(spare));
        const double most = *std::max_element(degrees.begin(), degrees.end());
        isTooFast_ = !std::isfinite(all) || (degreesPerKey_ >= kTooFar && most >= kTooFar);
    }

    // Whether two keys would still be about half a circle apart. Such keys are useless, and searching for
    // better ones takes long and finds none.
    bool isTooFast() const { return isTooFast_; }

    std::vector<double> split(const std::vector<double>& knots) const {
        if (degrees_.empty() || isTooFast_) return knots;
        std::vector<double> all{knots.front()};
        all.reserve(knots.size());
        for (std::size_t i = 1; i < knots.size(); ++i) {
            const int parts = static_cast<int>(std::ceil(degrees_[i - 1] / degreesPerKey_));
            for (int p = 1; p < parts; ++p)
                all.push_back(knots[i - 1] + (knots[i] - knots[i - 1]) * p / parts);
            all.push_back(knots[i]);
        }
        return all;
    }

private:
    static constexpr double kTooFar = 150.0;

    const std::vector<double>& degrees_;
    double degreesPerKey_ = 60.0;
    bool isTooFast_ = false;
};

// Whether the knots are complete, that is, none was left out for a limit.
bool hasAllKnots(const JointMotion& motion, std::size_t limit) {
    std::size_t knots = 2;
    for (const CurveBinding& binding : motion.bindings) knots += binding.curve->times.size();
    return knots < limit;
}

KeyTangents::Rates toRates(const TransformRates<double>& perWay, double seconds) {
    return {glm::vec3(perWay.position / seconds), glm::quat(perWay.rotation / seconds),
            glm::vec3(perWay.scale / seconds)};
}

void append(Channel& channel, const RunKeys<StraightTransform>& keys, bool isStep) {
    for (std::size_t i = 0; i < keys.times.size(); ++i) {
        JointTransform transform(keys.values[i]);
        // q and -q are the same rotation. Programs that blend quaternions number by number need neighbours
        // with a positive dot product.
        if (!channel.keyFrames.empty() &&
            glm::dot(channel.keyFrames.back().transform.rotation, transform.rotation) < 0.0f)
            transform.rotation = -transform.rotation;
        channel.keyFrames.push_back({keys.times[i], transform, isStep});
    }
}

void append(Channel& channel, const RunKeys<CurvedTransform>& keys, bool isStep) {
    for (std::size_t i = 0; i < keys.times.size(); ++i) {
        channel.keyFrames.push_back({keys.times[i], JointTransform(keys.values[i]), isStep});
        KeyTangents& tangents = channel.tangents.emplace_back();
        if (i > 0) tangents.in = toRates(keys.pieces[i - 1].arriving, keys.times[i] - keys.times[i - 1]);
        if (i < keys.pieces.size())
            tangents.out = toRates(keys.pieces[i].leaving, keys.times[i + 1] - keys.times[i]);
    }
}

void append(Channel& channel, const RunKeys<StraightMatrix>& keys, bool isStep) {
    for (std::size_t i = 0; i < keys.times.size(); ++i)
        channel.matrixKeyFrames.push_back({keys.times[i], glm::mat4(keys.values[i]), isStep});
}

void append(ParameterTrack& track, const RunKeys<StraightNumber>& keys, bool isStep) {
    for (std::size_t i = 0; i < keys.times.size(); ++i)
        track.keyFrames.push_back({keys.times[i], static_cast<float>(keys.values[i]), isStep});
}

void append(ParameterTrack& track, const RunKeys<CurvedNumber>& keys, bool isStep) {
    for (std::size_t i = 0; i < keys.times.size(); ++i) {
        track.keyFrames.push_back({keys.times[i], static_cast<float>(keys.values[i]), isStep});
        const auto rate = [&](double tangent, std::size_t from) {
            return static_cast<float>(tangent / (keys.times[from + 1] - keys.times[from]));
        };
        ParameterTrack::Tangents& tangents = track.tangents.emplace_back();
        if (i > 0) tangents.in = rate(keys.pieces[i - 1].arriving, i - 1);
        if (i < keys.pieces.size()) tangents.out = rate(keys.pieces[i].leaving, i);
    }
}

// Keys of one form, and the largest error that is left, as a distance in model space.
template <typename Target>
struct Fit {
    Target keys;
    double error = 0.0;
};

template <typename Form, typename Target, typename Exact>
Fit<Target> fitRuns(const std::vector<Run>& runs, Exact exact, const Tolerance& tolerance, bool isStraight,
                    std::size_t mostSplits, Target empty) {
    RunFitter<Form, Exact> fitter(exact, tolerance, isStraight);
    const auto keys = fitter.fit(runs, mostSplits);
    Fit<Target> fit{std::move(empty), fitter.largestError()};
    for (std::size_t i = 0; i < runs.size(); ++i) append(fit.keys, keys[i], runs[i].isStep);
    return fit;
}

// Tries the forms that a joint's keys can have, the cheapest first.
class ChannelFitter {
public:
    ChannelFitter(const JointMotion& motion, const std::vector<double>& times, const Tolerance& tolerance,
                  const KeyLimits& limits)
        : motion_(motion), tolerance_(tolerance), transforms_(motion, tolerance) {
        const std::size_t most = mostKeys(times.size(), limits);
        const std::vector<double> degrees = motion.degreesRotated(times);
        const RotationSplitter splitter(degrees, most - std::min(most, times.size()));
        const std::vector<double> knots = splitter.split(times);
        isTooFast_ = splitter.isTooFast();
        knots_ = knots.size();
        mostSplits_ = isTooFast_ ? 0 : most - std::min(most, knots_);
        const bool rotatesEvenly =
            !isTooFast_ && knots_ < most && hasAllKnots(motion, limits.most) && motion.rotatesEvenly();
        isStraight_ = rotatesEvenly || motion.isStraight();
        holds_ = isStraight_ || transforms_.holds(knots);
        const auto jumps = [&](double t) {
            return distance(motion.localTransform(t, Side::Left), motion.localTransform(t, Side::Right),
                            tolerance) > 0.01 * tolerance.budget;
        };
        runs_ = runsOf(motion, knots, jumps);
    }

    Channel fit() {
        if (!holds_) return fitMatrices();
        // If it is, matrices need no more keys than the file has.
        const bool isByNumber = motion_.isStraightByNumber();
        const std::size_t fewSplits = isByNumber ? runs_.size() : knots_ + 32 * runs_.size();
        Fit<Channel> straight =
            fitTransforms<StraightTransform>(isStraight_, std::min(mostSplits_, fewSplits));
        const std::size_t straightKeys = straight.keys.keyFrames.size();
        const bool isEnough = straight.error <= tolerance_.budget;
        if (!transforms_.holds() || (isByNumber && !isEnough)) return fitMatrices();
        if (isTooFast_ || (isEnough && straightKeys <= knots_)) return std::move(straight.keys);

        Fit<Channel> curved = fitTransforms<CurvedTransform>(false, mostSplits_);
        if (!transforms_.holds()) return fitMatrices();
        const bool isBetter =
            isEnough ? 2 * curved.keys.keyFrames.size() < straightKeys : curved.error < straight.error;
        return std::move(isBetter ? curved.keys : straight.keys);
    }

private:
    template <typename Form>
    Fit<Channel> fitTransforms(bool isStraight, std::size_t mostSplits) {
        const auto exact = [&](double seconds, Side side) { return transforms_.at(seconds, side); };
        return fitRuns<Form>(runs_, exact, tolerance_, isStraight, mostSplits,
                             Channel{.joint = motion_.joint});
    }

    // Matrices are interpolated number by number, and need many keys for a rotation. If they need too many,
    // transforms may be nearer, although they lose the shear.
    Channel fitMatrices() {
        const auto exact = [&](double seconds, Side side) { return motion_.localTransform(seconds, side); };
        Fit<Channel> best = fitRuns<StraightMatrix>(runs_, exact, tolerance_, motion_.isStraightByNumber(),
                                                    mostSplits_, Channel{.joint = motion_.joint});
        const auto take = [&](Fit<Channel> other) {
            if (other.error + transforms_.lost() < best.error) best = std::move(other);
        };
        if (best.error > tolerance_.budget && std::isfinite(transforms_.lost())) {
            take(fitTransforms<StraightTransform>(isStraight_, mostSplits_));
            take(fitTransforms<CurvedTransform>(false, mostSplits_));
        }
        return std::move(best.keys);
    }

    const JointMotion& motion_;
    const Tolerance& tolerance_;
    DecomposedMotion transforms_;
    std::vector<Run> runs_;
    std::size_t knots_ = 0, mostSplits_ = 0;
    bool isTooFast_ = false;   // see RotationSplitter
    bool isStraight_ = false;  // linear keys at the knots reproduce the motion
    bool holds_ = false;       // transforms seem to be enough: no matrices are needed
};

}  // namespace

Channel fitChannel(const JointMotion& motion, const std::vector<double>& times, const Tolerance& tolerance,
                   const KeyLimits& limits) {
    return ChannelFitter(motion, times, tolerance, limits).fit();
}

ParameterTrack fitTrack(const ParameterMotion& motion, const std::vector<double>& times,
                        const Tolerance& tolerance, const KeyLimits& limits) {
    const auto exact = [&](double seconds, Side side) { return motion.value(seconds, side); };
    const auto jumps = [&](double t) {
        return distance(exact(t, Side::Left), exact(t, Side::Right), tolerance) > 0.01 * tolerance.budget;
    };
    const std::vector<Run> runs = runsOf(motion, times, jumps);
    const std::size_t most = mostKeys(times.size(), limits), mostSplits = most - std::min(most, times.size());
    const std::size_t fewSplits = std::min(mostSplits, times.size() + 32 * runs.size());
    const ParameterTrack empty{.parameter = motion.parameter};
    auto straight = fitRuns<StraightNumber>(runs, exact, tolerance, false, fewSplits, empty);
    const std::size_t straightKeys = straight.keys.keyFrames.size();
    const bool isEnough = straight.error <= tolerance.budget;
    if (isEnough && straightKeys <= times.size()) return std::move(straight.keys);
    auto curved = fitRuns<CurvedNumber>(runs, exact, tolerance, false, mostSplits, empty);
    const bool isBetter =
        isEnough ? 2 * curved.keys.keyFrames.size() < straightKeys : curved.error < straight.error;
    return std::move(isBetter ? curved.keys : straight.keys);
}

}  // namespace walkcycle
