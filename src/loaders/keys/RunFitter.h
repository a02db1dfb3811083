#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "loaders/curves/Motion.h"
#include "loaders/keys/KeyForms.h"

namespace walkcycle {

// A part of the timeline without jumps inside. `knots` are the times at which a segment of a curve begins,
// with the first and the last time of the run. A run that holds one value and ends in a jump is a step.
struct Run {
    std::vector<double> knots;
    bool isStep = false;
};

// The keys of one run.
template <typename Form>
struct RunKeys {
    std::vector<double> times;
    std::vector<typename Form::Value> values;  // one per time
    std::vector<Form> pieces;                  // one between each two keys, for forms with tangents
};

// Finds few key frames for the runs of a motion, in two passes. refine() splits pieces until each is well
// within the tolerance. It always splits the worst piece of all runs, so that, if keys run out, they are
// where they help most; the order of the splits does not depend on the tolerance, which only ends them.
// leaveOut() then drops keys that are not needed.
template <typename Form, typename Exact>
class RunFitter {
public:
    using Value = typename Form::Value;
    using Keys = RunKeys<Form>;

    // `exact(seconds, side)` gives the motion. `isStraight`: it is known to have this form between its knots.
    RunFitter(Exact exact, const Tolerance& tolerance, bool isStraight)
        : exact_(std::move(exact)), tolerance_(tolerance), isStraight_(isStraight) {}

    // Returns the keys of each run. Adds at most `mostSplits` keys to the knots.
    std::vector<Keys> fit(const std::vector<Run>& runs, std::size_t mostSplits) {
        for (const Run& run : runs) addRun(run);
        refine(mostSplits);
        if (wasSplit_) sortSamples();
        std::vector<Keys> keys;
        keys.reserve(runs.size());
        for (std::size_t i = 0; i + 1 < firstNodes_.size(); ++i)
            keys.push_back(leaveOut(firstNodes_[i], firstNodes_[i + 1] - 1));
        return keys;
    }

    // The largest error of a piece after refine(), as a distance in model space. It exceeds Tolerance::budget
    // if there were too few splits.
    double largestError() const { return largestError_; }

private:
    struct Sample {
        double seconds;
        Value value;
    };
    static constexpr std::uint32_t kNone = UINT32_MAX;
    static constexpr std::size_t kProbes = 5;  // samples evenly spaced in a piece; its halves use them again
    using Probes = std::array<std::uint32_t, kProbes>;

    // The motion between two neighbouring keys. `start`, `stop` and `probes` are indices of samples_; `next`
    // is the index of the following piece.
    struct Piece {
        std::uint32_t start, stop;
        Probes probes;
        std::uint32_t next;
        int depth;
        double error;
    };

    void addRun(const Run& run) {
        const std::size_t count = run.isStep ? 1 : run.knots.size();
        nodes_.reserve(nodes_.size() + count);
        samples_.reserve(samples_.size() + (isStraight_ ? count : (kProbes + 1) * count));
        addNode(run.knots.front(), Side::Right);
        for (std::size_t i = 1; i < count; ++i) {
            const std::uint32_t start = nodes_.back();
            const Side side = i + 1 < count ? Side::Right : Side::Left;
            if (isStraight_) {
                addNode(run.knots[i], side);
                continue;
            }
            const Value stop = exact_(run.knots[i], side);
            Probes probes;
            for (std::size_t p = 0; p < kProbes; ++p) probes[p] = addProbe(start, run.knots[i], p);
            nodes_.push_back(static_cast<std::uint32_t>(samples_.size()));
            samples_.push_back({run.knots[i], stop});
            addPiece({start, nodes_.back(), probes, kNone, 0, 0.0});
        }
        firstNodes_.push_back(nodes_.size());
    }

    void addNode(double seconds, Side side) {
        nodes_.push_back(static_cast<std::uint32_t>(samples_.size()));
        samples_.push_back({seconds, exact_(seconds, side)});
    }

    std::uint32_t addProbe(std::uint32_t start, double stop, std::size_t probe) {
        const double from = samples_[start].seconds,
                     progression = static_cast<double>(probe + 1) / (kProbes + 1);
        const double seconds = from + (stop - from) * progression;
        samples_.push_back({seconds, exact_(seconds, Side::Right)});
        return static_cast<std::uint32_t>(samples_.size() - 1);
    }

    // The pieces of a run are linked in order of time. A piece that does not continue the last one begins a
    // run.
    void addPiece(Piece piece) {
        piece.error = errorOf(piece);
        if (!pieces_.empty() && pieces_.back().stop == piece.start)
            pieces_.back().next = static_cast<std::uint32_t>(pieces_.size());
        pieces_.push_back(piece);
    }

    double errorOf(const Piece& piece) const {
        const Sample &start = samples_[piece.start], &stop = samples_[piece.stop];
        const double middle = 0.5 * (start.seconds + stop.seconds);
        const auto probed =
            [&](double seconds) {  // a form asks for the values at the thirds, which are probes
                return samples_[piece.probes[seconds < middle ? 1 : 3]].value;
            };
        const Form form = Form::through(probed, start.seconds, stop.seconds, start.value, stop.value);
        double error = 0.0;
        for (std::size_t p = 0; p < kProbes; ++p)
            error =
                std::max(error, distance(samples_[piece.probes[p]].value,
                                         form.at(static_cast<double>(p + 1) / (kProbes + 1)), tolerance_));
        return error;
    }

    // Splits the worst piece, until all are within a share of the budget or there have been `mostSplits`.
    void refine(std::size_t mostSplits) {
        constexpr double kShare = 0.4;  // leaveOut() uses the rest
        const auto isBetter = [&](std::uint32_t a, std::uint32_t b) {
            return pieces_[a].error < pieces_[b].error;
        };
        std::vector<std::uint32_t> worst;  // a heap of the pieces to split
        const auto add = [&](std::uint32_t piece) {
            if (pieces_[piece].error <= kShare * tolerance_.budget) return;
            worst.push_back(piece);
            std::push_heap(worst.begin(), worst.end(), isBetter);
        };
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) add(i);
        while (!worst.empty() && mostSplits > 0) {
            std::pop_heap(worst.begin(), worst.end(), isBetter);
            const std::uint32_t piece = worst.back();
            worst.pop_back();
            if (!split(piece)) continue;
            --mostSplits;
            add(piece);
            add(static_cast<std::uint32_t>(pieces_.size() - 1));
        }
        for (const Piece& piece : pieces_) largestError_ = std::max(largestError_, piece.error);
    }

    // The piece becomes its first half, and its second half is appended. Returns false if the piece is too
    // short.
    bool split(std::uint32_t index) {
        constexpr int kDeepest = 24;
        const Piece whole = pieces_[index];
        const std::uint32_t middle = whole.probes[kProbes / 2];
        const double from = samples_[whole.start].seconds, to = samples_[whole.stop].seconds;
        const double between = samples_[middle].seconds;
        if (whole.depth >= kDeepest || !(from < between && between < to)) return false;
        Piece first{whole.start,     middle, {}, static_cast<std::uint32_t>(pieces_.size()),
                    whole.depth + 1, 0.0};
        Piece second{middle, whole.stop, {}, whole.next, whole.depth + 1, 0.0};
        for (std::size_t p = 0; p < kProbes; ++p) {
            const bool isKnown = p % 2 == 1;
            first.probes[p] = isKnown ? whole.probes[p / 2] : addProbe(first.start, between, p);
            second.probes[p] = isKnown ? whole.probes[p / 2 + kProbes / 2 + 1] : addProbe(middle, to, p);
        }
        first.error = errorOf(first), second.error = errorOf(second);
        pieces_[index] = first;
        pieces_.push_back(second);
        wasSplit_ = true;
        return true;
    }

    // Sorts samples and nodes by time again.
    void sortSamples() {
        std::vector<Sample> samples;
        samples.reserve(samples_.size());
        std::vector<std::uint32_t> nodes;
        std::vector<std::size_t> firstNodes{0};
        const auto addSortedNode = [&](std::uint32_t sample) {
            nodes.push_back(static_cast<std::uint32_t>(samples.size()));
            samples.push_back(samples_[sample]);
        };
        std::uint32_t piece = 0;  // first piece of the run: those of addRun() come first, run by run
        for (std::size_t run = 0; run + 1 < firstNodes_.size(); ++run) {
            const std::size_t knots = firstNodes_[run + 1] - firstNodes_[run];
            addSortedNode(nodes_[firstNodes_[run]]);
            for (std::uint32_t i = knots > 1 ? piece : kNone; i != kNone; i = pieces_[i].next) {
                for (const std::uint32_t probe : pieces_[i].probes) samples.push_back(samples_[probe]);
                addSortedNode(pieces_[i].stop);
            }
            piece += static_cast<std::uint32_t>(knots - 1);
            firstNodes.push_back(nodes.size());
        }
        samples_ = std::move(samples), nodes_ = std::move(nodes), firstNodes_ = std::move(firstNodes);
    }

    // From each key, finds the farthest node that one piece can reach: doubles the stride, then bisects.
    Keys leaveOut(std::size_t first, std::size_t last) const {
        const Sample& front = samples_[nodes_[first]];
        Keys keys{{front.seconds}, {front.value}, {}};
        for (std::size_t a = first; a < last;) {
            std::size_t good = a + 1, bad = last + 1;
            std::optional<Form> piece;  // the piece from a to good; empty if good is the next node
            for (std::size_t b = a + 2; b <= last && bad > last;) {
                const Form wider = pieceTo(keys.values.back(), a, b);
                if (fits(wider, a, b)) {
                    good = b, piece = wider;
                    b = b == last ? last + 1 : std::min(last, a + (b - a) * 2);
                } else {
                    bad = b;
                }
            }
            while (bad <= last && bad - good > 1) {
                const std::size_t b = (good + bad) / 2;
                const Form wider = pieceTo(keys.values.back(), a, b);
                if (fits(wider, a, b))
                    good = b, piece = wider;
                else
                    bad = b;
            }
            const Sample& reached = samples_[nodes_[good]];
            keys.times.push_back(reached.seconds);
            if constexpr (Form::kHasTangents) {
                if (!piece) piece = pieceTo(keys.values.back(), a, good);
                keys.values.push_back(piece->end());
                keys.pieces.push_back(*piece);
            } else {
                keys.values.push_back(reached.value);
            }
            a = good;
        }
        return keys;
    }

    Form pieceTo(const Value& start, std::size_t a, std::size_t b) const {
        const Sample& from = samples_[nodes_[a]];
        const Sample& to = samples_[nodes_[b]];
        const auto exact = [&](double seconds) { return exact_(seconds, Side::Right); };
        return Form::through(exact, from.seconds, to.seconds, start, to.value);
    }

    bool fits(const Form& piece, std::size_t a, std::size_t b) const {
        const double from = samples_[nodes_[a]].seconds, length = samples_[nodes_[b]].seconds - from;
        for (std::size_t i = nodes_[a] + 1; i < nodes_[b]; ++i)
            if (distance(samples_[i].value, piece.at((samples_[i].seconds - from) / length), tolerance_) >
                tolerance_.budget)
                return false;
        return true;
    }

    Exact exact_;
    Tolerance tolerance_;
    bool isStraight_;
    bool wasSplit_ = false;
    double largestError_ = 0.0;
    std::vector<Sample> samples_;             // nodes and the probes between them
    std::vector<std::uint32_t> nodes_;        // indices of the samples that may become keys
    std::vector<std::size_t> firstNodes_{0};  // of each run, and one more: the number of nodes
    std::vector<Piece> pieces_;
};

}  // namespace walkcycle
