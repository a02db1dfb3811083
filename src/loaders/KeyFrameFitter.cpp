#include "loaders/KeyFrameFitter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "loaders/RunFitter.h"
#include "loaders/StackParts.h"

namespace walkcycle {

namespace {

// A stretch of the timeline without jumps inside. One that ends in a jump and does not move is a step.
struct Run {
    std::vector<double> knots;
    bool isStep = false;
};

// Splits the time between `from` and `to` where the motion jumps. The last run may be of `to` alone: a jump there.
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

constexpr double kMostDegrees = 60.0;

// Whether a motion turns so fast that so many keys would be more than half a circle apart: then they say nothing, and
// looking for better ones would take long and find none.
bool isBeyondKeys(const std::vector<double>& degrees, std::size_t limit) {
    const double wanted = std::accumulate(degrees.begin(), degrees.end(), 0.0) / kMostDegrees;
    return !(wanted < 2.5 * static_cast<double>(limit));
}

// Whether the knots are all that the file has, and none was left out for a limit.
bool isAll(const JointMotion& motion, std::size_t limit) {
    std::size_t knots = 2;
    for (const CurveBinding& binding : motion.bindings) knots += binding.curve->times.size();
    return knots < limit;
}

// A turn of more than half a circle looks like a short one from its ends, so long turns are cut up beforehand.
// (`degrees` as JointMotion::degreesTurned gives them.)
std::vector<double> withTurnsCut(const std::vector<double>& knots, const std::vector<double>& degrees,
                                 std::size_t limit) {
    if (degrees.empty()) return knots;
    std::vector<double> cut{knots.front()};
    cut.reserve(knots.size());
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const double wanted = std::ceil(degrees[i - 1] / kMostDegrees);
        const double room = static_cast<double>(limit - std::min(limit, cut.size()));
        const int parts = static_cast<int>(std::clamp(wanted, 1.0, std::clamp(room, 1.0, 1e6)));
        for (int p = 1; p < parts; ++p) cut.push_back(knots[i - 1] + (knots[i] - knots[i - 1]) * p / parts);
        cut.push_back(knots[i]);
    }
    return cut;
}

// The exact motion of one joint as transforms; notices what they cannot hold.
class TransformOf {
public:
    TransformOf(const JointMotion& motion, const Tolerance& tolerance)
        : motion_(motion), tolerance_(tolerance), straight_(motion.isStraight()) {
        if (StackParts::canTell(motion)) stack_.emplace(motion);
    }

    ExactTransform at(double seconds, Side side) {
        const MatrixParts* const key = straight_ && side == Side::Right ? keyAt(seconds) : nullptr;
        MatrixParts other;
        if (!key && (!stack_ || !stack_->at(seconds, side, other)))
            other = partsOf(motion_.localTransform(seconds, side), near_);
        const MatrixParts& parts = key ? *key : other;
        near_ = glm::dot(parts.rotation, near_) < 0.0 ? -parts.rotation : parts.rotation;
        const bool isMirrored = parts.stretch[0][0] < 0.0;
        if (first_) wasMirrored_ = isMirrored;
        first_ = false;
        if (!parts.turns || isMirrored != wasMirrored_ || shear(parts, tolerance_) > 2.0 * tolerance_.budget)
            fits_ = false;
        return {parts.position, near_, parts.scale()};
    }
    bool fits() const { return fits_; }

    // Looks at the knots and between them, so that no keys are sought for what will not fit.
    bool fits(const std::vector<double>& knots) {
        for (std::size_t i = 1; i < knots.size() && fits_; ++i) {
            at(knots[i - 1], Side::Right);
            at(0.5 * (knots[i - 1] + knots[i]), Side::Right);
        }
        return fits_;
    }

private:
    // The parts of a key that is a whole matrix, which its curve knows already; null where they say too little.
    const MatrixParts* keyAt(double seconds) {
        const Curve& curve = *motion_.bindings[0].curve;
        const std::vector<double>& times = curve.times;
        ++key_;  // they are asked for one after the other
        if (key_ >= times.size() || times[key_] != seconds || times[key_ - 1] == seconds)
            key_ = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), seconds) -
                                            times.begin());
        const bool isKey = key_ < times.size() && times[key_] == seconds;
        if (!isKey || (key_ + 1 < times.size() && times[key_ + 1] == seconds) || curve.parts.empty())
            return nullptr;
        return curve.parts[key_].turns ? &curve.parts[key_] : nullptr;
    }

    const JointMotion& motion_;
    const Tolerance& tolerance_;
    const bool straight_;
    std::optional<StackParts> stack_;
    std::size_t key_ = 0;
    glm::dquat near_{1.0, 0.0, 0.0, 0.0};
    bool first_ = true, wasMirrored_ = false, fits_ = true;
};

KeyTangents::Rates toRates(const TransformRates<double>& perWay, double seconds) {
    return {glm::vec3(perWay.position / seconds), glm::quat(perWay.rotation / seconds),
            glm::vec3(perWay.scale / seconds)};
}

void append(Channel& channel, const RunKeys<StraightTransform>& keys, bool isStep) {
    for (std::size_t i = 0; i < keys.times.size(); ++i)
        channel.keyFrames.push_back({keys.times[i], JointTransform(keys.values[i]), isStep});
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

// Fits every run in one form. `exact(seconds, side)` gives the motion. False where the limit came before the tolerance.
template <typename Form, typename Exact, typename Target>
bool fitRuns(const std::vector<Run>& runs, Exact exact, const Tolerance& tolerance, bool isStraight,
             std::size_t limit, Target& target) {
    bool isWithin = true;
    for (const Run& run : runs) {
        const double end = run.knots.back();
        const auto within = [&](double seconds) {
            return exact(seconds, run.knots.size() > 1 && seconds == end ? Side::Left : Side::Right);
        };
        const std::vector<double> first{run.knots.front()};
        RunFitter<Form, decltype(within)> fitter(within, tolerance, isStraight, limit);
        const auto keys = fitter.fit(run.isStep ? first : run.knots);
        append(target, keys, run.isStep);
        isWithin = isWithin && keys.isWithin;
    }
    return isWithin;
}

Channel fitMatrices(const JointMotion& motion, const std::vector<Run>& runs, const Tolerance& tolerance,
                    std::size_t limit) {
    Channel channel{.joint = motion.joint};
    const auto exact = [&](double seconds, Side side) { return motion.localTransform(seconds, side); };
    fitRuns<StraightMatrix>(runs, exact, tolerance, motion.isStraightByNumber(), limit, channel);
    return channel;
}

// How many keys a motion may get whose file has so many times: a turn of a thousand rounds between two keys must not
// cost more than the file itself is worth. What is lost by that is measured and said (WC0513).
std::size_t mostKeys(std::size_t knots, std::size_t spare, std::size_t limit) {
    return std::min(limit, 2 * knots + 32 + std::min(spare, 4096 + 64 * knots));
}

}  // namespace

Channel fitChannel(const JointMotion& motion, const std::vector<double>& times, const Tolerance& tolerance,
                   std::size_t limit, std::size_t spare) {
    const bool allKnots = isAll(motion, limit);
    limit = mostKeys(times.size(), spare, limit);
    const std::vector<double> degrees = motion.degreesTurned(times);
    const bool isBeyond = isBeyondKeys(degrees, limit);
    const std::vector<double> knots = isBeyond ? times : withTurnsCut(times, degrees, limit);
    if (isBeyond) limit = times.size();
    const auto jumps = [&](double t) {
        return distance(motion.localTransform(t, Side::Left), motion.localTransform(t, Side::Right),
                        tolerance) > 0.01 * tolerance.budget;
    };
    const std::vector<Run> runs = runsOf(motion, knots, jumps);
    TransformOf transform(motion, tolerance);
    const auto exact = [&](double seconds, Side side) { return transform.at(seconds, side); };

    const bool turnsStraight = !isBeyond && allKnots && knots.size() < limit && motion.turnsStraight();
    const bool isStraight = turnsStraight || motion.isStraight();
    if (!isStraight && !transform.fits(knots)) return fitMatrices(motion, runs, tolerance, limit);
    Channel straight{.joint = motion.joint};
    const bool byNumber = motion.isStraightByNumber();  // then matrices need no more keys than the file has
    const std::size_t fewEnough = std::min(limit, byNumber ? knots.size() + 1 : 2 * knots.size() + 32);
    const bool enough = fitRuns<StraightTransform>(runs, exact, tolerance, isStraight, fewEnough, straight);
    if (isBeyond && transform.fits()) return straight;
    if (!enough && spare == 0 && transform.fits()) return straight;
    if (byNumber && !enough) return fitMatrices(motion, runs, tolerance, limit);
    if (transform.fits() && (!enough || straight.keyFrames.size() > knots.size())) {
        Channel curved{.joint = motion.joint};
        fitRuns<CurvedTransform>(runs, exact, tolerance, false, limit, curved);
        if (transform.fits() && (!enough || 2 * curved.keyFrames.size() < straight.keyFrames.size()))
            return curved;
    }
    return transform.fits() ? straight : fitMatrices(motion, runs, tolerance, limit);
}

ParameterTrack fitTrack(const ParameterMotion& motion, const std::vector<double>& knots,
                        const Tolerance& tolerance, std::size_t limit, std::size_t spare) {
    const auto exact = [&](double seconds, Side side) { return motion.value(seconds, side); };
    const auto jumps = [&](double t) {
        return distance(exact(t, Side::Left), exact(t, Side::Right), tolerance) > 0.01 * tolerance.budget;
    };
    limit = mostKeys(knots.size(), spare, limit);
    const std::vector<Run> runs = runsOf(motion, knots, jumps);
    ParameterTrack straight{.parameter = motion.parameter};
    const std::size_t fewEnough = std::min(limit, 2 * knots.size() + 32);
    const bool enough = fitRuns<StraightNumber>(runs, exact, tolerance, false, fewEnough, straight);
    if (enough && straight.keyFrames.size() <= knots.size()) return straight;
    ParameterTrack curved{.parameter = motion.parameter};
    fitRuns<CurvedNumber>(runs, exact, tolerance, false, limit, curved);
    return !enough || 2 * curved.keyFrames.size() < straight.keyFrames.size() ? curved : straight;
}

}  // namespace walkcycle
